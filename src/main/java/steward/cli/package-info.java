/**
 * The command line: {@link steward.cli.Main} and the list of commands. Each command is one small class in {@code play},
 * {@code replay}, {@code lab} or {@code bench}; options that several have stand in {@code options}, what else they
 * share in {@code shared}, which alone lists the games ({@link steward.cli.shared.Games}). It decides nothing about
 * rules, bots or formats.
 *
 * <p>Results go to the standard output, everything else to the standard error. People start the program thousands of
 * times, so a command is only loaded when it is called by its name, and reads JSON as a stream.
 */
@Internal
package steward.cli;

import steward.Internal;
