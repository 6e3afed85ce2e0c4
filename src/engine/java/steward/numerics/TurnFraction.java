package steward.numerics;

/**
 * Angle in radians as a fraction of a full turn, without the whole turns. The error is below 2^-203 for every finite
 * double from 2^-28 on. The method is that of M. Payne and R. Hanek, "Radian Reduction for Trigonometric Functions"
 * (1983): only a window of the digits of 2 / pi has to be multiplied. Digits outside it give whole turns, or are too
 * small to count.
 */
final class TurnFraction {

    /**
     * The binary digits of 2 / pi behind the point, 64 a word, two words of zeros ahead of them. The largest double
     * needs the first 1225.
     */
    private static final long[] TWO_OVER_PI = {
        0, 0,
        0xa2f9836e4e441529L, 0xfc2757d1f534ddc0L, 0xdb6295993c439041L, 0xfe5163abdebbc561L,
        0xb7246e3a424dd2e0L, 0x06492eea09d1921cL, 0xfe1deb1cb129a73eL, 0xe88235f52ebb4484L,
        0xe99c7026b45f7e41L, 0x3991d639835339f4L, 0x9c845f8bbdf9283bL, 0x1ff897ffde05980fL,
        0xef2f118b5a0a6d1fL, 0x6d367ecf27cb09b7L, 0x4f463f669e5fea2dL, 0x7527bac7ebe5f17bL,
        0x3d0739f78a5292eaL, 0x6bfb5fb11f8d5d08L, 0x56033046fc7b6babL, 0xf0cfbc209af4361dL};

    private static final int FRACTION_BITS = 52;
    private static final long FRACTION = (1L << FRACTION_BITS) - 1;

    private long first;
    private long second;
    private long third;
    private long fourth;

    /*
     * The angle is m 2^e with a whole m below 2^53, so it makes m 2^(e-2) (2 / pi) turns. Cut the digits of 2 / pi
     * after e - 2 of them: what is before, times 2^(e-2), is a whole number, and m times it are whole turns. From there
     * on 256 digits are taken; the rest is less than 2^-256, and m times it less than 2^-203. The product of m and the
     * window is below 2^53; its 256 digits behind the point are kept.
     */

    /** Sets the fraction to that of an angle from 2^-28 on. */
    void set(double angle) {
        long bits = Double.doubleToRawLongBits(angle);
        long m = bits & FRACTION | FRACTION + 1;
        int position = Math.getExponent(angle) - FRACTION_BITS - 2 + 2 * Long.SIZE;
        int word = position >> 6;
        fourth = m * digits(word + 3, position);
        long carry = WideFraction.multiplyHigh(m, digits(word + 3, position));
        long digits = digits(word + 2, position);
        third = m * digits + carry;
        carry = WideFraction.multiplyHigh(m, digits) + WideFraction.carry(third, carry);
        digits = digits(word + 1, position);
        second = m * digits + carry;
        carry = WideFraction.multiplyHigh(m, digits) + WideFraction.carry(second, carry);
        first = m * digits(word, position) + carry;
    }

    /** 64 digits from a position within a word on, only the lower six bits of which count. */
    private static long digits(int word, int position) {
        return TWO_OVER_PI[word] << position | TWO_OVER_PI[word + 1] >>> 1 >>> ~position;
    }

    /** The 64 binary digits behind the point, then 64 more each. */
    long first() {
        return first;
    }

    long second() {
        return second;
    }

    long third() {
        return third;
    }

    long fourth() {
        return fourth;
    }
}
