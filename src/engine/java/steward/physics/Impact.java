package steward.physics;

/**
 * Record of one impulse, with the velocities before and after it and its momentum and energy.
 *
 * @param time     within the turn, 0..1
 * @param a        id of the first body
 * @param b        id of the second body, or {@code ~w} (negative) for the wall with index w
 * @param ax       centre of a at the impact, before any push-out
 * @param bx       centre of b; for a wall, the point where it was hit
 * @param normalX  unit vector from a to b
 * @param impulse  the whole impulse j along the normal: a is given -j n, b is given +j n
 * @param energy   the change of kinetic energy, (wa + wb)(j2^2 - j1^2) / 2, in pod masses times u^2 per turn^2
 * @param massA    mass of a, may be infinite
 * @param massB    mass of b, infinite for a wall
 * @param vaxBefore velocity of a before
 * @param vaxAfter  velocity of a after, as stored
 * @param vbxBefore velocity of b before; 0 for a wall
 */
public record Impact(double time, int a, int b, double ax, double ay, double bx, double by,
                     double normalX, double normalY, double impulse, double energy, double massA, double massB,
                     double vaxBefore, double vayBefore, double vaxAfter, double vayAfter,
                     double vbxBefore, double vbyBefore, double vbxAfter, double vbyAfter) {

    /** How many numbers an impact has after {@code time, a, b}. */
    static final int NUMBERS = 18;

    public boolean isWall() {
        return b < 0;
    }

    /** Index of the wall that was hit. */
    public int wall() {
        return ~b;
    }

    /**
     * The momentum that a received, x: m (v after - v before) of the stored velocities, or -j n if its mass is
     * infinite.
     */
    public double momentumAx() {
        return massA < Double.POSITIVE_INFINITY ? massA * (vaxAfter - vaxBefore) : -impulse * normalX;
    }

    /** The momentum that a received, y. */
    public double momentumAy() {
        return massA < Double.POSITIVE_INFINITY ? massA * (vayAfter - vayBefore) : -impulse * normalY;
    }

    /** The momentum that b received, x; for a wall or an infinite mass, j n. */
    public double momentumBx() {
        return massB < Double.POSITIVE_INFINITY ? massB * (vbxAfter - vbxBefore) : impulse * normalX;
    }

    /** The momentum that b received, y. */
    public double momentumBy() {
        return massB < Double.POSITIVE_INFINITY ? massB * (vbyAfter - vbyBefore) : impulse * normalY;
    }
}
