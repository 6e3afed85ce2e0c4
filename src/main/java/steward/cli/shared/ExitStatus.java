package steward.cli.shared;

/** Exit statuses of the program. */
public final class ExitStatus {

    /** Done: a match has its result, also if a bot failed; a replay is verified. */
    public static final int DONE = 0;
    /** A verification differs, a match could not be brought to a result, or a bot failed in a strict match. */
    public static final int FAILED = 1;
    /** The call or an input cannot be used. */
    public static final int UNUSABLE = 2;

    /** Refused by another program: a league does not take a worker. */
    public static final int REFUSED = 3;

    private ExitStatus() { }
}
