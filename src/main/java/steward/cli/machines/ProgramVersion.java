package steward.cli.machines;

import steward.cli.shared.Games;

/** The version of this program, for those it plays with. */
final class ProgramVersion {

    private ProgramVersion() {
    }

    /** Such as {@code 0.1.0}; {@code development} outside an installation. */
    static String text() {
        String version = Games.class.getPackage().getImplementationVersion();
        return version == null ? "development" : version;
    }
}
