/**
 * Bots as they are given on the command line. Splits words as a shell does, reads prefixes for the protocol, lists the
 * bundled bots, and finds the program.
 */
package steward.bot.command;
