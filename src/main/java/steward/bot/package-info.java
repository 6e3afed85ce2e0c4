/**
 * Players of a match: an in-process {@link steward.bot.Bot}, or a process with deadlines and limits. This package moves
 * lines; it knows no game, no rules and no scores. A failure of a bot is a value, the readable text {@link
 * steward.bot.Answer#fault()}. Processes are in {@code process}, their use of time in {@code accounting}, bots on the
 * command line in {@code command}.
 */
package steward.bot;
