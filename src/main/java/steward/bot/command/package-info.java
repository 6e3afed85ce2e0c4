/** Bots as the command line names them: words as of a shell, prefixes, the bundled bots, and the program. */
package steward.bot.command;
