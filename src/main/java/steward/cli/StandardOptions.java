package steward.cli;

import java.util.List;
import picocli.CommandLine.Option;

/** Options that every command has. */
final class StandardOptions {

    private static final String SHORT = "-V";
    private static final String LONG = "--version";

    /** The names of the option that prints the version. */
    static final List<String> VERSION = List.of(SHORT, LONG);

    @Option(names = {"-h", "--help"}, usageHelp = true, description = "Prints this help.")
    private boolean help;

    @Option(names = {SHORT, LONG}, versionHelp = true, description = "Prints the version.")
    private boolean version;
}
