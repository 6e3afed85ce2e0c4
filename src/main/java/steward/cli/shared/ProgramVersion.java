package steward.cli.shared;

/** Version of this program, for programs that it plays with and for its measurements. */
public final class ProgramVersion {

    private ProgramVersion() { }

    /** Such as {@code 0.1.0}; {@code development} outside an installation. */
    public static String text() {
        String version = Games.class.getPackage().getImplementationVersion();
        return version == null ? "development" : version;
    }
}
