package steward.numerics;

/**
 * Arc tangent with the bits of {@link StrictMath}, several times as fast: compiled in place instead of called. {@code
 * StrictMath} is specified to give the results of the algorithms of the "Freely Distributable Math Library" (fdlibm
 * 5.3). For common arguments these are evaluated here with its polynomial, its reduction and its order of operations;
 * for all others {@code StrictMath} itself is called. Tests compare the two, bit for bit.
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

    /*
     * The algorithm tells its cases apart by the upper 32 bits of |x|. Where that is a bound on |x| itself it is
     * written as one here (0x3fdc0000 is 0.4375 exactly). What is left to
     * StrictMath are arguments that are rare in a game and would need more code: not finite, tiny or far out.
     */
    private static final double LEAST_RATIO = 0x1p-28;
    private static final double GREATEST_RATIO = 0x1p58;

    private StrictAngles() { }

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
}
