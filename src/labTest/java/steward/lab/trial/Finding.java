package steward.lab.trial;

/**
 * Result of a stability case on a rung.
 *
 * @param verdict what it means
 * @param text    the figures, readable
 */
public record Finding(Verdict verdict, String text) {

    /** Verdict on a case's demand. */
    public enum Verdict {
        /** The demand is met. */
        HOLDS,
        /** The demand is not met. */
        FAILS,
        /** Nothing is demanded of this rung; the figures are for comparison. */
        REPORTED
    }

    /** The result where something is demanded of this rung. */
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
