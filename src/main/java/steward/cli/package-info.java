/**
 * The command line: one small class per command, and what it prints. The only room that lists the games
 * ({@link steward.cli.shared.Games}); it decides nothing about rules, bots or formats.
 *
 * <p>Results go to the standard output, everything else to the standard error. People start the program thousands of
 * times, so a command is only loaded when it is called by its name, and reads JSON as a stream.
 */
package steward.cli;
