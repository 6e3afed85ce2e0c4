package steward.physics;

import java.util.Locale;

/** The arithmetic of a turn. What each one does for a time of impact is documented in {@code physics.time}. */
public enum Arithmetic {

    /** The published referee's own expressions: the same bits as the server. */
    OFFICIAL,

    /** Closed forms without cancellation, in doubles. */
    DOUBLE,

    /** The same quadratic with the rounding errors of its products and sums added back. */
    COMPENSATED,

    /**
     * Exact decisions: whether a pair touches, approaches or meets is decided by exact signs, and times of impact,
     * positions at impacts, impulses and new velocities are computed in double-double and rounded once, when they are
     * stored.
     */
    EXACT;

    /** Its name in a scene. */
    public String text() {
        return name().toLowerCase(Locale.ROOT);
    }
}
