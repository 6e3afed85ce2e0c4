package steward.physics;

import java.util.Locale;

/** Arithmetic in which a turn is computed. {@code physics.time} documents the times of impact of each. */
public enum Arithmetic {

    /** The published referee's own expressions: the same bits as the server. */
    OFFICIAL,

    /** Closed forms without cancellation, in doubles. */
    DOUBLE,

    /** The quadratic of {@link #DOUBLE} with the rounding errors of its products and sums added back. */
    COMPENSATED,

    /**
     * Exact decisions: whether a pair touches, approaches or meets is decided by exact signs, and times of impact,
     * positions at impacts, impulses and new velocities are computed in double-double and rounded once, when they are
     * stored.
     */
    EXACT;

    /** True if decisions are exact. */
    public boolean isExact() {
        return switch (this) {
            case EXACT -> true;
            case OFFICIAL, DOUBLE, COMPENSATED -> false;
        };
    }

    /** True if times come from the expressions of official referees, in which official games bring their own. */
    public boolean isOfficial() {
        return switch (this) {
            case OFFICIAL -> true;
            case DOUBLE, COMPENSATED, EXACT -> false;
        };
    }

    /** Its name in a scene. */
    public String text() {
        return name().toLowerCase(Locale.ROOT);
    }
}
