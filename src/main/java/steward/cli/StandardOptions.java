package steward.cli;

import picocli.CommandLine.Option;

/** The options that every command has. */
final class StandardOptions {

    @Option(names = {"-h", "--help"}, usageHelp = true, description = "Prints this help.")
    private boolean help;

    @Option(names = {"-V", "--version"}, versionHelp = true, description = "Prints the version.")
    private boolean version;
}
