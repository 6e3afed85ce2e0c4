package steward.physics;

/** Who wants to know what happened inside a turn. Called in the order of time; must allocate nothing to be fast. */
public interface TurnSink {

    /** Wants to know nothing. */
    TurnSink NONE = new TurnSink() {
    };

    /** An impact; the parameters are the components of {@link Impact}, in its order. */
    default void impact(double time, int a, int b, double ax, double ay, double bx, double by,
                        double normalX, double normalY, double impulse, double energy, double massA, double massB,
                        double vaxBefore, double vayBefore, double vaxAfter, double vayAfter,
                        double vbxBefore, double vbyBefore, double vbxAfter, double vbyAfter) {
    }

    /** A corner of a body's path: where it was touched, or was moved to by a push-out. */
    default void knot(int bodyId, double time, double x, double y) {
    }

    /**
     * The bound on impacts was reached. The bodies that are then still in contact, and those that come into contact
     * later, keep their places for the rest of the turn and keep their velocities; the others fly on.
     *
     * @param bodyIds who stayed, ascending; allocated, because this is rare
     */
    default void impactLimit(double time, int[] bodyIds) {
    }
}
