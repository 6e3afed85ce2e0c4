package steward.physics.time;

import java.util.List;
import steward.physics.Bodies;
import steward.physics.Segment;
import steward.physics.Wall;

/*
 * With lengths (coordinates, radii) L and speeds V that are 0 or in the ranges below, a difference of two is 0 or at
 * least 2^-252 of lengths, and the terms of the quadratic of TimeOfImpact, up to (V L)^2, stay below 2^804. They stay
 * above 2^-1000 for speeds from 2^-300; slower bodies do not come 2^-252 nearer within a turn, so that a pair that does
 * not touch now will not touch in this turn, and a touching pair is decided by d.v, at least 2^-952. An impulse, mass
 * times speed, is 2^-1000 to 2^501.
 */

/**
 * Check that squares and fourth powers of a turn's numbers are in the range of doubles, so that plain arithmetic is
 * safe. Otherwise a square is silently 0 or infinite. A turn with numbers outside these ranges is computed in the exact
 * arithmetic on every rung, which scales by powers of two; numbers that are out of range for that too are refused by
 * name. The check is made once, at the start of a turn.
 */
public final class Magnitudes {

    private static final double SHORTEST = 0x1p-200;
    private static final double LONGEST = 0x1p200;
    private static final double SLOWEST = 0x1p-700;
    private static final double FASTEST = 0x1p200;
    private static final double LIGHTEST = 0x1p-300;
    private static final double HEAVIEST = 0x1p300;
    /** Sums and differences of a few such lengths or speeds are finite. */
    private static final double LARGEST = 0x1p1000;
    private static final double LARGEST_MOMENTUM = 0x1p1020;

    private Magnitudes() { }

    /**
     * True if all lengths are 0 or 6.3e-61..1.6e60, all speeds 0 or 2e-211..1.6e60, all masses 5e-91..2e90 or infinite.
     */
    public static boolean fitPlainArithmetic(Bodies bodies) {
        for (int i = 0; i < bodies.size(); i++) {
            if (!(isLength(bodies.x[i]) && isLength(bodies.y[i]) && isSpeed(bodies.vx[i]) && isSpeed(bodies.vy[i])
                && isLength(bodies.radius[i]) && isMass(bodies.mass[i]))) {
                return false;
            }
        }
        return true;
    }

    private static boolean isLength(double value) {
        double size = Math.abs(value);
        return size <= LONGEST && (size >= SHORTEST || size == 0);
    }

    private static boolean isSpeed(double value) {
        double size = Math.abs(value);
        return size <= FASTEST && (size >= SLOWEST || size == 0);
    }

    private static boolean isMass(double value) {
        return value >= LIGHTEST && (value <= HEAVIEST || value == Double.POSITIVE_INFINITY);
    }

    /**
     * Refuses what exact arithmetic cannot compute.
     *
     * @throws IllegalArgumentException naming the body, the quantity, what was found and what was expected
     */
    public static void requireComputable(Bodies bodies, List<Wall> walls) {
        boolean segments = walls.stream().anyMatch(Segment.class::isInstance);
        for (int i = 0; i < bodies.size(); i++) {
            requireLength(bodies, i, "x", bodies.x[i], segments);
            requireLength(bodies, i, "y", bodies.y[i], segments);
            requireLength(bodies, i, "radius", bodies.radius[i], segments);
            requireSpeed(bodies, i, "vx", bodies.vx[i]);
            requireSpeed(bodies, i, "vy", bodies.vy[i]);
        }
    }

    private static void requireLength(Bodies bodies, int i, String what, double value, boolean segments) {
        require(Math.abs(value) <= LARGEST, bodies, i, what, value, "a magnitude of at most " + LARGEST);
        require(!segments || isLength(value), bodies, i, what, value,
            "0 or a magnitude of " + SHORTEST + ".." + LONGEST + " where walls are segments");
    }

    private static void requireSpeed(Bodies bodies, int i, String what, double value) {
        require(Math.abs(value) <= LARGEST, bodies, i, what, value, "a magnitude of at most " + LARGEST);
        double momentum = Math.abs(value) * bodies.mass[i];
        require(momentum <= LARGEST_MOMENTUM || bodies.mass[i] == Double.POSITIVE_INFINITY, bodies, i, what, value,
            "a momentum of at most " + LARGEST_MOMENTUM + " (its mass is " + bodies.mass[i] + ")");
    }

    private static void require(boolean inRange, Bodies bodies, int i, String what, double value, String expected) {
        if (!inRange) {
            throw new IllegalArgumentException(
                "body " + bodies.id(i) + ": " + what + " " + value + ", expected " + expected);
        }
    }
}
