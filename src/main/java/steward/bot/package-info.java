/**
 * A player: an in-process {@link steward.bot.Bot} or a process with its deadlines and limits. This room moves
 * lines; it knows no game, no rules and no scores.
 *
 * <p>A {@link steward.bot.command.BotCommand} is what a person writes; {@link steward.bot.process.BotProcess} starts it when it is
 * asked for the first time and {@link steward.bot.InProcessPlayer} needs no process. Whatever goes wrong with a bot
 * is a value, {@link steward.bot.Answer#fault()}, in words for people.
 *
 * <p>Four helpers serve all bot processes: one watchdog thread for the deadlines, one small sentinel process that
 * survives this JVM long enough to kill what it leaves behind, a process group per bot, and a file without a name per
 * bot for its stderr.
 */
package steward.bot;
