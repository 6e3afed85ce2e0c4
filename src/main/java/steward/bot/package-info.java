/**
 * A player: an in-process {@link steward.bot.Bot} or a process with its deadlines and limits. This room moves lines; it
 * knows no game, no rules and no scores. A failure of a bot is a value, the readable text
 * {@link steward.bot.Answer#fault()}. Processes are in {@code process}, what they do with their time in
 * {@code accounting}, the naming of bots on the command line in {@code command}.
 */
package steward.bot;
