package steward.numerics;

/**
 * Cosine and sine from their power series in 192 binary digits, rounded to the nearest double. It is slow and always
 * right, for every finite angle from 2^-28 on. Cosine and sine are left in fields. Allocates nothing.
 */
final class SineCosineSeries {

    /** Powers beyond are not needed: (pi/4)^44 / 44! is below 2^-195. Of small angles even fewer are. */
    private static final int LAST = 43;
    private static final int DIGITS = 192;
    private static final int WORDS = 3;
    /** 1/n!, three words each. */
    private static final long[] RECIPROCAL_FACTORIALS = new long[WORDS * (LAST + 1)];

    static {
        WideFraction reciprocal = new WideFraction().set(1L << 63, 0, 0);
        for (int n = 2; n <= LAST; n++) {
            RECIPROCAL_FACTORIALS[WORDS * n] = reciprocal.high();
            RECIPROCAL_FACTORIALS[WORDS * n + 1] = reciprocal.middle();
            RECIPROCAL_FACTORIALS[WORDS * n + 2] = reciprocal.low();
            reciprocal.divide(n + 1);
        }
    }

    private final TurnFraction turns = new TurnFraction();
    private final WideFraction quarterPi =
        new WideFraction().set(0xc90fdaa22168c234L, 0xc4c6628b80dc1cd1L, 0x29024e088a67cc74L);
    private final WideFraction angle = new WideFraction();
    private final WideFraction square = new WideFraction();
    private final WideFraction sum = new WideFraction();

    private double cos;
    private double sin;

    double cos() {
        return cos;
    }

    double sin() {
        return sin;
    }

    /*
     * Errors, in units v = 2^-192. The remaining angle a <= pi/4 is the product of u <= 1 (too small by less than 1 v,
     * and by 2^-200) and pi/4 (by less than 1 v), cut off by 6 v: below 8 v. Its square: below 2 a 8 + 6 < 19 v.
     * A step of a sum, s = 1/n! - a^2 s', has 2 v from 1/n! (cut off at every division), 6 v from the product, 19 s' v
     * from the square, and 0.617 times the error of s': for the cosine, where s' < 1/24, and for the sine (1/120), the
     * last s, below 1/2 and 1/6, has less than (2 + 6 + 19/24) / (1 - 0.617) < 23 v.
     * The cosine 1 - a^2 s: below 0.617 * 23 + 19/2 + 6 < 30 v. The sine a - a (a^2 s): below
     * 8 + 0.786 (0.617 * 23 + 19/6 + 6) + 0.11 * 8 + 6 < 34 v. Powers left out make less than 1 v. Either is off by
     * less than 2^-186.
     *
     * That is enough if no cosine or sine is that near to the middle between two doubles. Up to pi all doubles have
     * been searched: at most 59 equal digits follow the one that decides the rounding (V. Lefevre and J.-M. Muller,
     * "Worst Cases for Correct Rounding of the Elementary Functions in Double Precision", 2001; Lefevre's lists of 2020
     * in CORE-MATH), so that no result is nearer to a middle than 2^-168. Beyond pi no complete search is known, and
     * the digits are taken as random: between 2^-j and 2^(1-j) doubles are 2^(-52-j) apart, so that a share of
     * 2^(j-133) of all numbers lies within 2^-186 of a middle. Fewer than 2^(66-j) results are there, and none beyond
     * j = 61 (no double is nearer to a multiple of pi/2; J.-M. Muller, "Elementary Functions", on range reduction). So
     * the chance that even one such result exists is below 2^-60.
     */

    /** Computes both of a finite angle, of size 2^-28 or more. */
    void turn(double radians) {
        turns.set(Math.abs(radians));
        int quarter = (int) (turns.first() + (1L << 61) >>> 62);
        long rest = turns.first() - ((long) quarter << 62);
        // The size of the rest, at most 1/8 turn, as a share u of 1/8. A complement is short by 2^-256 of its negative.
        long sign = rest >> 63;
        long first = rest ^ sign;
        long second = turns.second() ^ sign;
        long third = turns.third() ^ sign;
        angle.set(first << 3 | second >>> 61, second << 3 | third >>> 61, third << 3 | (turns.fourth() ^ sign) >>> 61);
        angle.multiply(quarterPi);
        square.set(angle).multiply(angle);
        int last = Math.min(LAST, DIGITS / Math.max(1, angle.leadingZeros()) + 1);
        double cosine = alternatingSum(last & ~1, 2).subtractFromOne().toDouble();
        double sine = alternatingSum(last - 1 | 1, 3).multiply(angle).subtractFrom(angle).toDouble();
        sine = sign < 0 ? -sine : sine;
        boolean odd = (quarter & 1) != 0;
        double turnedCosine = odd ? sine : cosine;
        double turnedSine = odd ? cosine : sine;
        cos = quarter == 1 || quarter == 2 ? -turnedCosine : turnedCosine;
        sin = quarter >= 2 != radians < 0 ? -turnedSine : turnedSine;
    }

    /** The angle's square times (1/first! - square/(first + 2)! + square^2/(first + 4)! - ... up to last!). */
    private WideFraction alternatingSum(int last, int first) {
        sum.set(0, 0, 0);
        for (int n = last; n >= first; n -= 2) {
            sum.subtractFrom(RECIPROCAL_FACTORIALS[WORDS * n], RECIPROCAL_FACTORIALS[WORDS * n + 1],
                RECIPROCAL_FACTORIALS[WORDS * n + 2]).multiply(square);
        }
        return sum;
    }
}
