/**
 * Bots as they are named on the command line: splitting words as a shell does, prefixes for the protocol, the bundled
 * bots, and finding the program.
 */
package steward.bot.command;
