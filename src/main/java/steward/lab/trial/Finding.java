package steward.lab.trial;

/**
 * What was seen of a case on a rung.
 *
 * @param verdict what it means
 * @param text    the figures, for people
 */
public record Finding(Verdict verdict, String text) {

    /** What a case's demand has become of. */
    public enum Verdict {
        /** The demand is met. */
        HOLDS,
        /** It is not. */
        FAILS,
        /** Nothing is demanded of this rung; the figures are for comparison. */
        REPORTED
    }

    /** Something is demanded of this rung, and it is met or not. */
    public static Finding demanded(boolean met, String text) {
        return new Finding(met ? Verdict.HOLDS : Verdict.FAILS, text);
    }

    public static Finding reported(String text) {
        return new Finding(Verdict.REPORTED, text);
    }

    /** @param demanded whether anything is demanded of this rung */
    public static Finding of(boolean demanded, boolean met, String text) {
        return demanded ? demanded(met, text) : reported(text);
    }
}
