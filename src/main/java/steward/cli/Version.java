package steward.cli;

import picocli.CommandLine.IVersionProvider;
import steward.cli.shared.ProgramVersion;

/** Text of {@code --version}: the version in the jar's manifest, if the program runs from a jar. */
final class Version implements IVersionProvider {

    @Override
    public String[] getVersion() {
        return new String[] {"steward " + ProgramVersion.text()};
    }
}
