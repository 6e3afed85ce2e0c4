package steward.numerics;

/**
 * Arc tangent, cosine and sine with the bits of {@link StrictMath}, several times as fast: compiled in place instead
 * of called, cosine and sine with one reduction. {@code StrictMath} is specified to give what the algorithms of the
 * "Freely Distributable Math Library" (fdlibm 5.3) give; for the common arguments these are evaluated here with its
 * polynomials, its reductions and its order of operations, and for all others {@code StrictMath} itself is called.
 * Tests hold the two together, bit for bit.
 *
 * <p>Not thread-safe: cosine and sine are left in fields.
 */
public final class StrictAngles {

    private static final double PI_LOW = 0x1.1a62633145c07p-53;
    private static final double HALF_PI = 0x1.921fb54442d18p0;
    private static final double HALF_PI_LOW = 0x1.1a62633145c07p-54;
    private static final double QUARTER_PI_LOW = 0x1.1a62633145c07p-55;

    /** The arc tangents of 1/2 and 3/2, each in two parts: x is reduced to its difference from them. */
    private static final double ATAN_HALF = 0x1.dac670561bb4fp-2;
    private static final double ATAN_HALF_LOW = 0x1.a2b7f222f65e2p-56;
    private static final double ATAN_THREE_HALVES = 0x1.f730bd281f69bp-1;
    private static final double ATAN_THREE_HALVES_LOW = 0x1.007887af0cbbdp-56;

    /** Per range of x: p, q, r, s, high, low. */
    private static final double[] RANGES = {
        1, 0, 1, 0, 0, 0,
        2, 1, 2, 1, ATAN_HALF, ATAN_HALF_LOW,
        1, 1, 1, 1, Math.PI / 4, QUARTER_PI_LOW,
        1, 1.5, 1, 1.5, ATAN_THREE_HALVES, ATAN_THREE_HALVES_LOW,
        0, 1, 0, 1, HALF_PI, HALF_PI_LOW};
    private static final double[] RANGE_ENDS = {0.4375, 0.6875, 1.1875, 2.4375};
    /** The ends of the ranges differ in the exponent and the first five bits of the fraction. */
    private static final int RANGE_SHIFT = 47;
    private static final long FIRST_RANGE = Double.doubleToRawLongBits(0.25) >> RANGE_SHIFT;
    /** By these bits, from 1/4 up to 4: where the row begins. */
    private static final byte[] RANGE_OF = new byte[128];

    static {
        for (int k = 0; k < RANGE_OF.length; k++) {
            double least = Double.longBitsToDouble(FIRST_RANGE + k << RANGE_SHIFT);
            for (double end : RANGE_ENDS) {
                RANGE_OF[k] += least >= end ? 6 : 0;
            }
        }
    }

    /** Coefficients of atan(x) = x - x^3 (A0 + A1 x^2 + A2 x^4 + ...) for |x| below 7/16. */
    private static final double A0 = 0x1.555555555550dp-2;
    private static final double A1 = -0x1.999999998ebc4p-3;
    private static final double A2 = 0x1.24924920083ffp-3;
    private static final double A3 = -0x1.c71c6fe231671p-4;
    private static final double A4 = 0x1.745cdc54c206ep-4;
    private static final double A5 = -0x1.3b0f2af749a6dp-4;
    private static final double A6 = 0x1.10d66a0d03d51p-4;
    private static final double A7 = -0x1.dde2d52defd9ap-5;
    private static final double A8 = 0x1.97b4b24760debp-5;
    private static final double A9 = -0x1.2b4442c6a6c2fp-5;
    private static final double A10 = 0x1.0ad3ae322da11p-6;

    /** pi/2 in two parts, the first of 33 bits, so that its small multiples are exact; and 2/pi. */
    private static final double HALF_PI_33 = 0x1.921fb544p0;
    private static final double HALF_PI_REST = 0x1.0b4611a626331p-34;
    private static final double TWO_OVER_PI = 0x1.45f306dc9c883p-1;

    /** Coefficients of sin(x) = x + S1 x^3 + S2 x^5 + ... for |x| up to pi/4. */
    private static final double S1 = -0x1.5555555555549p-3;
    private static final double S2 = 0x1.111111110f8a6p-7;
    private static final double S3 = -0x1.a01a019c161d5p-13;
    private static final double S4 = 0x1.71de357b1fe7dp-19;
    private static final double S5 = -0x1.ae5e68a2b9cebp-26;
    private static final double S6 = 0x1.5d93a5acfd57cp-33;

    /** Coefficients of cos(x) = 1 - x^2 / 2 + C1 x^4 + C2 x^6 + ... for |x| up to pi/4. */
    private static final double C1 = 0x1.555555555554cp-5;
    private static final double C2 = -0x1.6c16c16c15177p-10;
    private static final double C3 = 0x1.a01a019cb159p-16;
    private static final double C4 = -0x1.27e4f809c52adp-22;
    private static final double C5 = 0x1.1ee9ebdb4b1c4p-29;
    private static final double C6 = -0x1.8fae9be8838d4p-37;

    /*
     * The algorithm tells its cases apart by the upper 32 bits of |x|. Where that is a bound on |x| itself it is
     * written as one here (0x3fdc0000 is 0.4375 exactly, 0x3fd33333 is 0x1.33333p-2, and so on). What is left to
     * StrictMath are arguments that are rare in a game and would need more code: not finite, tiny, far out, or so near
     * a multiple of pi/2 that a reduction in two parts does not suffice.
     */
    private static final double LEAST_RATIO = 0x1p-28;
    private static final double GREATEST_RATIO = 0x1p58;
    private static final double LEAST_ANGLE = 0x1p-26;
    /** The upper 32 bits of |x| are at most those of pi/4. */
    private static final double UP_TO_QUARTER_PI = 0x1.921fcp-1;
    /** A reduction by 31 quarter turns at most is exact in two parts, unless it ends near zero. */
    private static final double GREATEST_ANGLE = 48;
    /** Near zero: below this share of the angle the upper 32 bits of the angle may be those of a quarter turn. */
    private static final double NEAR = 0x1p-18;

    private double cos;
    private double sin;

    /** The cosine of the last {@link #turn}. */
    public double cos() {
        return cos;
    }

    /** The sine of the last {@link #turn}. */
    public double sin() {
        return sin;
    }

    /** Returns the bits of {@code StrictMath.atan2(y, x)}. */
    public static double atan2(double y, double x) {
        double ratio = Math.abs(y / x);
        if (!(ratio >= LEAST_RATIO && ratio <= GREATEST_RATIO)) {
            return StrictMath.atan2(y, x);            // also on the axes, and at whatever is not finite
        }
        double angle = atan(ratio);
        double right = x > 0 ? angle : Math.PI - (angle - PI_LOW);
        return Math.copySign(right, y);
    }

    /**
     * Of x from {@link #LEAST_RATIO} up: atan(x) = high + low + atan((p x - q) / (r + s x)), one row of {@link #RANGES}
     * for each of five ranges of x. Factors 0, 1 and 2 and the term 0 cost no rounding, so that this is the algorithm's
     * expression for each range; looking a row up is faster than branching five ways.
     */
    private static double atan(double x) {
        long bits = Double.doubleToRawLongBits(x) >> RANGE_SHIFT;
        int row = RANGE_OF[(int) Math.max(0, Math.min(RANGE_OF.length - 1, bits - FIRST_RANGE))];
        double rest = (RANGES[row] * x - RANGES[row + 1]) / (RANGES[row + 2] + RANGES[row + 3] * x);
        double square = rest * rest;
        return RANGES[row + 4] - (rest * polynomial(square, square * square) - RANGES[row + 5] - rest);
    }

    /** A0 x^2 + A1 x^4 + ..., even and odd coefficients summed apart. */
    private static double polynomial(double square, double fourth) {
        double even = square * (A0 + fourth * (A2 + fourth * (A4 + fourth * (A6 + fourth * (A8 + fourth * A10)))));
        double odd = fourth * (A1 + fourth * (A3 + fourth * (A5 + fourth * (A7 + fourth * A9))));
        return even + odd;
    }

    /** Computes {@code StrictMath.cos(angle)} and {@code StrictMath.sin(angle)}: see {@link #cos()}, {@link #sin()}. */
    public void turn(double angle) {
        double size = Math.abs(angle);
        if (size < UP_TO_QUARTER_PI && size >= LEAST_ANGLE) {
            double square = angle * angle;
            cos = cosine(size, square, 0);
            double cube = square * angle;
            sin = angle + cube * (S1 + square * sineTail(square));
            return;
        }
        if (!(size <= GREATEST_ANGLE)) {
            strict(angle);
            return;
        }
        int quarter = (int) (size * TWO_OVER_PI + 0.5);
        double reduced = size - quarter * HALF_PI_33;
        double correction = quarter * HALF_PI_REST;
        double high = reduced - correction;
        double low = (reduced - high) - correction;
        if (!(Math.abs(high) >= size * NEAR) || quarter == 0) {
            strict(angle);
            return;
        }
        double square = high * high;
        double c = cosine(Math.abs(high), square, high * low);
        double cube = square * high;
        double s = high - ((square * (0.5 * low - cube * sineTail(square)) - low) - cube * S1);
        // Which is which, and the signs, by bits: branches would be guessed wrong half of the time.
        long cosBits = Double.doubleToRawLongBits(c);
        long sinBits = Double.doubleToRawLongBits(s);
        long swap = (cosBits ^ sinBits) & -(quarter & 1);
        cos = Double.longBitsToDouble(cosBits ^ swap ^ (quarter + 1L & 2) << 62);
        sin = Double.longBitsToDouble(sinBits ^ swap
            ^ ((long) quarter << 62 ^ Double.doubleToRawLongBits(angle)) & Long.MIN_VALUE);
    }

    private void strict(double angle) {
        cos = StrictMath.cos(angle);
        sin = StrictMath.sin(angle);
    }

    private static double sineTail(double square) {
        return S2 + square * (S3 + square * (S4 + square * (S5 + square * S6)));
    }

    /** The cosine of an angle in two parts, from the size and square of the first and the product of both. */
    private static double cosine(double size, double square, double product) {
        double tail = square * (square * (C1 + square * (C2 + square * (C3 + square * (C4 + square * (C5
            + square * C6)))))) - product;
        if (size < 0x1.33333p-2) {
            return 1 - (0.5 * square - tail);
        }
        // About a quarter of the size, exactly representable: 1 less that loses nothing.
        double quarter = size >= 0x1.90001p-1 ? 0.28125
            : Double.longBitsToDouble((Double.doubleToRawLongBits(size) & 0xffffffff00000000L) - 0x0020000000000000L);
        return 1 - quarter - (0.5 * square - quarter - tail);
    }
}
