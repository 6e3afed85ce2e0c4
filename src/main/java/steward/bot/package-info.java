/**
 * A player: an in-process {@link steward.bot.Bot} or a process with its deadlines and limits. This room moves
 * lines; it knows no game, no rules and no scores. Whatever goes wrong with a bot is a value,
 * {@link steward.bot.Answer#fault()}, in words for people. Processes stand in {@code process}, what a person writes to
 * name a bot in {@code command}.
 */
package steward.bot;
