/**
 * Bots as processes, with deadlines. A {@link steward.bot.process.BotProcess} starts its program when it is asked for
 * the first time.
 *
 * <p>A {@link steward.bot.process.QuestionClock} decides when its time is up, and records how the time was spent.
 *
 * <p>It uses four helpers: one watchdog thread for all deadlines, one small sentinel process that outlives this JVM
 * long enough to kill remaining bots, a process group per bot, and an unnamed file per bot for its stderr.
 */
package steward.bot.process;
