/**
 * Bots as processes. A {@link steward.bot.process.BotProcess} starts its program when it is asked for the first time.
 *
 * <p>Four helpers serve all of them: one watchdog thread for the deadlines, one small sentinel process that survives
 * this JVM long enough to kill what it leaves behind, a process group per bot, and a file without a name per bot for
 * its stderr.
 */
@Internal
package steward.bot.process;

import steward.Internal;
