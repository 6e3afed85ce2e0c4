package steward.cli;

import picocli.CommandLine.IVersionProvider;

/** Text of {@code --version}: the version in the jar's manifest, if the program runs from one. */
final class Version implements IVersionProvider {

    @Override
    public String[] getVersion() {
        String version = Version.class.getPackage().getImplementationVersion();
        return new String[] {"steward " + (version == null ? "development" : version)};
    }
}
