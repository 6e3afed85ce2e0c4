package steward.game.podrace;

import steward.numerics.SineCosine;
import steward.numerics.StrictAngles;

/**
 * Headings of pods, turned without computing angles. The rules keep a heading as an angle in radians, every bit of
 * which follows from arc tangents and sums. Here it is kept twice: as a unit vector accurate to {@link #VECTOR_ERROR},
 * which suffices for nearly all steering, and as a deferred exact value. That value consists of the arguments of an arc
 * tangent that has not been computed yet and the turns by 18 degrees since. It is computed only when the angle is read,
 * or when the vector cannot decide. Allocates nothing.
 *
 * <p>The headings themselves are in an array of the caller, {@link #NUMBERS} numbers per pod from an offset on.
 */
public final class Headings {

    /** The greatest change of a heading in a turn, in radians: 18 degrees. */
    public static final double MAXIMUM_TURN = Math.PI / 10;
    static final double FULL_TURN = 2 * Math.PI;

    /*
     * The error of the vector. In the game the direction of an angle h is (cos h, sin h) divided by its length; call
     * "true" the direction of the stored double h itself. u = 2^-53.
     *
     * (1) cos, sin, length and quotients of the game: within 6 u of the true direction of h.
     * (2) After a turn straight to the target, h is StrictMath's atan2 (2 units in the last place of pi: 16 u), and the
     *     vector is (dx, dy) times root / square (the rounding of the square moves root / square by half as much: 1 u;
     *     root, reciprocal, both products: 4 u): together with (1) below 2^-48.
     * (3) A vector computed from the angle itself is the game's own.
     * (4) A turn by 18 degrees adds the double pi / 10 to h, rounded: with |h| < 2^10 by at most 2^-44 (half a unit in
     *     the last place). The rotation of the vector by the cosine and sine of pi / 10 rounds by less than 2^-50.
     *     After the maximum of 40 such turns: below 40 (2^-44 + 2^-50) < 2^-38.
     *
     * |h| < 2^10 holds because vectors are computed only from angles below 2^9, and 40 turns add less than 13.
     */

    /**
     * Bound on the length of the difference between a vector and the one that the game computes from the exact angle.
     */
    public static final double VECTOR_ERROR = 0x1p-37;

    /*
     * The vectors decide whether to turn by 18 degrees, and to which side, where the cosine differs from that of 18
     * degrees, and the sine from 0, by more than DOUBT. The game's own angle between the two, r, carries the rounding
     * of a difference of angles below 2^10 + 4 and of multiples of the double 2 pi: less than 2^-40; so the two
     * computations of r differ by less than 2^-36, and cosine and sine by no more.
     */
    public static final double DOUBT = 0x1p-30;
    static final double COSINE = 0x1.e6f0e134454ffp-1;
    public static final double SINE = 0x1.3c6ef372fe94fp-2;
    /**
     * Bound for squares of cosines, which are compared without a square root: with C the cosine of 18 degrees, (C +
     * DOUBT)^2 - C^2 and C^2 - (C - DOUBT)^2 are below 2 DOUBT; the rest covers rounding.
     */
    static final double SQUARE_DOUBT = 2.5 * DOUBT;

    /** A turn by 18 degrees as a part of the greatest: 18 times this double is 1. */
    private static final double PART_OF_TURN = 1.0 / 18;

    /** Angles from this magnitude on have no vector. */
    private static final double GREATEST_ANGLE = 0x1p9;
    /** Squares of distances below lose digits to underflow; the squares of those above could overflow. */
    private static final double LEAST_SQUARE = 0x1p-400;
    private static final double GREATEST_SQUARE = 0x1p400;
    /** A chain of 40 turns: the leading 1 and 40 bits. */
    static final double LONGEST = 0x1p40;

    /** Offsets of the vector; NaN while unset, or when the angle is too large. */
    public static final int X = 0;
    public static final int Y = 1;
    /**
     * Offsets of the base of the exact value: atan2(BASE_Y, BASE_X), or, with NaN for BASE_Y, the angle BASE_X itself
     * (NaN: unset).
     */
    public static final int BASE_X = 2;
    public static final int BASE_Y = 3;
    /**
     * The turns by 18 degrees since the base, as the bits of a whole number: a leading 1, then one bit for each turn, 1
     * for a positive one.
     */
    public static final int CHAIN = 4;
    /** The size of a heading in the array. */
    public static final int NUMBERS = 5;

    private final SineCosine direction = new SineCosine();
    private double directionX;
    private double directionY;

    /** @param angle in radians, NaN for unset */
    public void set(double[] to, int at, double angle) {
        to[at + BASE_X] = angle;
        to[at + BASE_Y] = Double.NaN;
        to[at + CHAIN] = 1;
        if (Math.abs(angle) < GREATEST_ANGLE) {
            computeDirection(angle);
            to[at + X] = directionX;
            to[at + Y] = directionY;
        } else {
            to[at + X] = Double.NaN;
            to[at + Y] = Double.NaN;
        }
    }

    /** Computes the direction of an angle as the game does. */
    private void computeDirection(double angle) {
        direction.turn(angle);
        double cos = direction.cos();
        double sin = direction.sin();
        double length = Math.sqrt(cos * cos + sin * sin);
        directionX = cos / length;
        directionY = sin / length;
    }

    /** Computes the direction exactly as the game does: see {@link #directionX()}, {@link #directionY()}. */
    public void direct(double[] headings, int at) {
        double angle = angle(headings, at);
        computeDirection(angle);
        headings[at + BASE_X] = angle;
        headings[at + BASE_Y] = Double.NaN;
        headings[at + CHAIN] = 1;
        if (Math.abs(angle) < GREATEST_ANGLE) {
            headings[at + X] = directionX;
            headings[at + Y] = directionY;
        }
    }

    public double directionX() {
        return directionX;
    }

    public double directionY() {
        return directionY;
    }

    /** The exact angle in radians; NaN while unset. */
    public static double angle(double[] headings, int at) {
        double angle = headings[at + BASE_X];
        double baseY = headings[at + BASE_Y];
        if (!Double.isNaN(baseY)) {
            angle = StrictAngles.atan2(baseY, angle);
        }
        double turns = headings[at + CHAIN];
        return turns == 1 ? angle : turned(angle, (long) turns);
    }

    public static boolean isUnset(double[] headings, int at) {
        return Double.isNaN(headings[at + BASE_X]);
    }

    private static double turned(double base, long turns) {
        double angle = base;
        for (int bit = 62 - Long.numberOfLeadingZeros(turns); bit >= 0; bit--) {
            angle += (turns >> bit & 1) != 0 ? MAXIMUM_TURN : -MAXIMUM_TURN;
        }
        return angle;
    }

    /** Turns a pod towards a target at (dx, dy) relative to it, not both 0, by at most 18 degrees. */
    public void turnTo(double[] headings, int at, double dx, double dy) {
        if (!turnQuickly(headings, at, dx, dy)) {
            set(headings, at, turned(angle(headings, at), StrictAngles.atan2(dy, dx)));
        }
    }

    /**
     * Turns a pod as {@link #turnTo} does, by vectors, unless they cannot decide. The turn straight to the target and
     * the turn by 18 degrees are both computed and one is selected, the vector by weights of 0 and 1, the exact value
     * by bits: a branch would be mispredicted too often.
     *
     * @return whether the heading was turned; if not, it is as before
     */
    public static boolean turnQuickly(double[] headings, int at, double dx, double dy) {
        double hx = headings[at + X];
        double hy = headings[at + Y];
        double square = dx * dx + dy * dy;
        double along = hx * dx + hy * dy;
        double across = hx * dy - hy * dx;
        double chain = headings[at + CHAIN];
        double within = along * Math.abs(along) - COSINE * COSINE * square;
        if (!(Math.abs(within) > SQUARE_DOUBT * square && (across * across > DOUBT * DOUBT * square || within > 0)
            && square > LEAST_SQUARE && square < GREATEST_SQUARE && chain < LONGEST)) {
            return false;
        }
        long beyond = Double.doubleToRawLongBits(within) >> 63;
        double turned = -beyond;
        // the root and the reciprocal are independent
        double straight = Math.sqrt(square) * ((1 - turned) / square);
        double sine = Math.copySign(SINE, across) * turned;
        double cosine = COSINE * turned;
        headings[at + X] = dx * straight + (hx * cosine - hy * sine);
        headings[at + Y] = dy * straight + (hx * sine + hy * cosine);
        headings[at + BASE_X] = select(dx, headings[at + BASE_X], beyond);
        headings[at + BASE_Y] = select(dy, headings[at + BASE_Y], beyond);
        headings[at + CHAIN] = 1 + turned * (2 * chain - 0.5 + Math.copySign(0.5, across));
        return true;
    }

    /**
     * Turns a pod relative to its heading: the exact value becomes heading + toRadians(degrees), one addition of
     * doubles, for 18 degrees that of {@link #MAXIMUM_TURN}. 0 degrees leave the heading as it is, bit for bit, and an
     * unset heading stays unset.
     *
     * @param degrees -18..18
     */
    public void turnBy(double[] headings, int at, double degrees) {
        double radians = Math.toRadians(degrees);
        if (!turnByQuickly(headings, at, degrees) && radians != 0) {
            set(headings, at, angle(headings, at) + radians);
        }
    }

    /**
     * Turns a pod as {@link #turnBy} does, by 18, -18 or 0 degrees and by vectors: nothing has to be decided, so
     * nothing is in doubt. The vector is rotated and the exact value gets one more turn; for 0 degrees by a rotation
     * that changes nothing, which saves a branch that would be mispredicted.
     *
     * @return whether the heading was turned; if not, as for other angles, it is as before
     */
    public static boolean turnByQuickly(double[] headings, int at, double degrees) {
        double hx = headings[at + X];
        double hy = headings[at + Y];
        double chain = headings[at + CHAIN];
        double side = degrees * PART_OF_TURN;
        double size = Math.abs(side);
        if (!(size * size == size && Math.abs(hx) <= 2 && chain < LONGEST)) {
            return false;
        }
        double cosine = 1 + size * (COSINE - 1);      // exact for 0 and 1
        double sine = side * SINE;
        headings[at + X] = hx * cosine - hy * sine;
        headings[at + Y] = hx * sine + hy * cosine;
        headings[at + CHAIN] = chain + size * (chain + 0.5) + 0.5 * side;
        return true;
    }

    /** The first value if the mask is 0, the second if it is -1. */
    private static double select(double first, double second, long mask) {
        long bits = Double.doubleToRawLongBits(first);
        return Double.longBitsToDouble(bits ^ (bits ^ Double.doubleToRawLongBits(second)) & mask);
    }

    /** The heading after a turn from one angle towards another. */
    public static double turned(double angle, double wanted) {
        double delta = remainder(wanted - angle);
        double shortest = remainder(2 * delta) - delta;
        if (Math.abs(shortest) >= MAXIMUM_TURN) {
            return angle + (shortest > 0 ? MAXIMUM_TURN : -MAXIMUM_TURN);
        }
        return wanted;                                // also for an unset angle: the difference is NaN
    }

    /** {@code angle % FULL_TURN}: a difference of two numbers within a factor of 2 is exact, as the remainder is. */
    private static double remainder(double angle) {
        double size = Math.abs(angle);
        if (size < FULL_TURN) {
            return angle;
        }
        if (size <= 2 * FULL_TURN) {
            double rest = size - FULL_TURN;
            return Math.copySign(rest == FULL_TURN ? 0 : rest, angle);
        }
        return angle % FULL_TURN;
    }
}
