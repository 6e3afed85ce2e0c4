/**
 * The command line: {@link steward.cli.Main} and the list of commands. Each command is one small class in a package
 * below. Options that several commands have are in {@code options}; other shared code is in {@code shared}, which alone
 * lists the games ({@link steward.cli.shared.Games}). The command line contains no logic of rules, bots or formats.
 *
 * <p>Results go to the standard output, everything else to the standard error. The program is started thousands of
 * times, so a command's class is loaded only when it is called, and JSON is read as a stream.
 */
package steward.cli;
