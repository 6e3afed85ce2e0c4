/**
 * Isolation of a bot's processes from others: the levels, which of them this machine offers, and how each starts a
 * program. It knows programs and their limits, not their answers.
 */
package steward.bot.isolation;
