package steward.physics;

import java.util.Locale;

/** With how much care a turn is computed; what each does about a time of impact stands with the times themselves. */
public enum Arithmetic {

    /** The published referee's own expressions: the same bits as the server. */
    OFFICIAL,

    /** Closed forms without cancellation, in doubles. */
    DOUBLE,

    /** The same quadratic with the errors of its products and sums put back. */
    COMPENSATED,

    /**
     * Exact decisions: who touches, approaches or meets is a matter of exact signs, and times of impact, positions at
     * impacts, impulses and new velocities are computed in double-double and rounded once, when they are stored.
     */
    EXACT;

    /** Its name in a scene. */
    public String text() {
        return name().toLowerCase(Locale.ROOT);
    }
}
