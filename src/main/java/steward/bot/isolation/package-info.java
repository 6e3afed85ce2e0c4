/**
 * How a bot's processes are kept apart from all others: the levels of isolation, which of them this machine offers, and
 * what is done to start a program in each. Knows programs and their limits, not their answers.
 */
@Internal
package steward.bot.isolation;

import steward.Internal;
