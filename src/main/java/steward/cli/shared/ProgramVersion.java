package steward.cli.shared;

/** The version of this program, for those it plays with and for what it has measured. */
public final class ProgramVersion {

    private ProgramVersion() { }

    /** Such as {@code 0.1.0}; {@code development} outside an installation. */
    public static String text() {
        String version = Games.class.getPackage().getImplementationVersion();
        return version == null ? "development" : version;
    }
}
