/**
 * The command line: {@link steward.cli.Main} and the list of commands. Each command is one small class in
 * {@code play}, {@code replay}, {@code lab}, {@code bench} or {@code setup}; options that several have are in
 * {@code options}, what else they share is in {@code shared}, which alone lists the games
 * ({@link steward.cli.shared.Games}). It contains no logic of rules, bots or formats.
 *
 * <p>Results go to the standard output, everything else to the standard error. The program is started thousands of
 * times, so a command is loaded only when it is called by its name, and reads JSON as a stream.
 */
package steward.cli;
