package steward.physics;

/**
 * Observer of a turn, which receives impacts and path knots in the order of time. To be fast, it must allocate nothing.
 */
public interface TurnSink {

    /** Ignores everything. */
    TurnSink NONE = new TurnSink() {
    };

    /** An impact; the parameters are the components of {@link Impact}, in its order. */
    default void impact(double time, int a, int b, double ax, double ay, double bx, double by,
                        double normalX, double normalY, double impulse, double energy, double massA, double massB,
                        double vaxBefore, double vayBefore, double vaxAfter, double vayAfter,
                        double vbxBefore, double vbyBefore, double vbxAfter, double vbyAfter) { }

    /** A knot of a body's path: the place of an impact, or the place after a positional correction. */
    default void knot(int bodyId, double time, double x, double y) { }

    /**
     * Receives an act of a game's {@link Reaction} or official expressions, in the order of time; the meaning is the
     * game's.
     *
     * @param kind of fact, a number of the game
     * @param a    id of a body, or another number of the game
     * @param b    the same
     * @param x    a place, in u
     * @param y    the same
     * @param p    a number of the game
     * @param q    the same
     */
    default void fact(double time, int kind, int a, int b, double x, double y, double p, double q) { }

    /**
     * A heap came to rest where no force acts.
     *
     * @param energy what bounces would have given back: of the kinetic energy that each contact took, its restitution's
     *               square
     */
    default void rest(double time, double energy) { }

    /**
     * The bound on impacts was reached. The bodies that are then still in contact, and those that come into contact
     * later, keep their place for the rest of the turn and keep their velocities; the others fly on.
     *
     * @param bodyIds the bodies that kept their place, ascending; allocated, because this is rare
     */
    default void impactLimit(double time, int[] bodyIds) { }
}
