/**
 * Isolation of a bot's processes from all others: the levels, which of them this machine offers, and how a program is
 * started in each. Knows programs and their limits, not their answers.
 */
package steward.bot.isolation;
