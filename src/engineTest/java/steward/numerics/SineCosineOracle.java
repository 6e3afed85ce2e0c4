package steward.numerics;

import java.math.BigInteger;

/**
 * Sine and cosine in whole numbers of any length, for tests: nothing is shared with what it judges. pi is that of
 * J. Machin (1706), pi/4 = 4 arctan(1/5) - arctan(1/239); the angle less the nearest multiple of pi/2 is split into a
 * multiple of 1/64, of which sine and cosine are kept, and a rest, of which they come from the Taylor series.
 */
final class SineCosineOracle {

    /** Binary digits behind the point: results are off by less than 2^-240. */
    static final int DIGITS = 256;

    private static final int PI_DIGITS = 1024 + 2 * DIGITS;
    private static final BigInteger PI = arcTangentOfInverse(5).multiply(BigInteger.valueOf(4))
        .subtract(arcTangentOfInverse(239)).shiftLeft(2);
    /** Below, more digits are needed. */
    private static final double SMALL = 0x1p-8;
    /** More than what a result may be off by, in units. */
    private static final BigInteger DOUBT = BigInteger.ONE.shiftLeft(16);

    private static final BigInteger[] KEPT_SINES = new BigInteger[52];
    private static final BigInteger[] KEPT_COSINES = new BigInteger[52];

    static {
        for (int k = 0; k < KEPT_SINES.length; k++) {
            BigInteger angle = BigInteger.valueOf(k).shiftLeft(DIGITS - 6);
            KEPT_SINES[k] = series(angle, 1, DIGITS);
            KEPT_COSINES[k] = series(angle, 0, DIGITS);
        }
    }

    private int digits;
    private BigInteger sine;
    private BigInteger cosine;

    private static BigInteger arcTangentOfInverse(int x) {
        BigInteger power = BigInteger.ONE.shiftLeft(PI_DIGITS + 32).divide(BigInteger.valueOf(x));
        BigInteger sum = power;
        for (int n = 3; power.signum() != 0; n += 2) {
            power = power.divide(BigInteger.valueOf((long) -x * x));
            sum = sum.add(power.divide(BigInteger.valueOf(n)));
        }
        return sum.shiftRight(32);
    }

    /** pi times 2^digits, off by less than 2. */
    static BigInteger pi(int digits) {
        return PI.shiftRight(PI_DIGITS - digits);
    }

    /** Computes both of a finite angle. */
    void turn(double angle) {
        double size = Math.abs(angle);
        digits = size < SMALL ? DIGITS - 2 * Math.getExponent(size) : DIGITS;
        int more = Math.max(0, Math.getExponent(size)) + 2;
        BigInteger rest = scaled(size, digits + more);
        int quarters = 0;
        if (size >= SMALL) {
            BigInteger halfPi = pi(digits + more).shiftRight(1);
            BigInteger count = rest.shiftLeft(1).add(halfPi).divide(halfPi.shiftLeft(1));
            rest = rest.subtract(count.multiply(halfPi));
            quarters = count.intValue() & 3;
        }
        turnRest(rest.shiftRight(more), quarters);
        sine = angle < 0 ? sine.negate() : sine;
    }

    /** Computes both of an angle times 2^{@link #DIGITS}, from 0 to pi/2. */
    void turn(BigInteger angle) {
        digits = DIGITS;
        boolean far = angle.compareTo(pi(DIGITS).shiftRight(2)) > 0;
        turnRest(far ? angle.subtract(pi(DIGITS).shiftRight(1)) : angle, far ? 1 : 0);
    }

    private void turnRest(BigInteger rest, int quarters) {
        int kept = rest.abs().shiftRight(digits - 6).intValue();
        BigInteger size = rest.abs().subtract(BigInteger.valueOf(kept).shiftLeft(digits - 6));
        BigInteger s = series(size, 1, digits);
        BigInteger c = series(size, 0, digits);
        if (kept > 0) {
            BigInteger both = KEPT_SINES[kept].multiply(c).add(KEPT_COSINES[kept].multiply(s)).shiftRight(digits);
            c = KEPT_COSINES[kept].multiply(c).subtract(KEPT_SINES[kept].multiply(s)).shiftRight(digits);
            s = both;
        }
        s = rest.signum() < 0 ? s.negate() : s;
        sine = (quarters & 1) == 0 ? s : c;
        cosine = (quarters & 1) == 0 ? c : s;
        sine = quarters >= 2 ? sine.negate() : sine;
        cosine = quarters == 1 || quarters == 2 ? cosine.negate() : cosine;
    }

    /** x^n/n! - x^(n+2)/(n+2)! + ... from n = 0 or 1 on. */
    private static BigInteger series(BigInteger x, int first, int digits) {
        BigInteger square = x.multiply(x).shiftRight(digits);
        BigInteger term = first == 0 ? BigInteger.ONE.shiftLeft(digits) : x;
        BigInteger sum = term;
        for (int n = first + 1; term.signum() != 0; n += 2) {
            term = term.multiply(square).shiftRight(digits).divide(BigInteger.valueOf(-(long) n * (n + 1)));
            sum = sum.add(term);
        }
        return sum;
    }

    /** A double times 2^digits, cut off. */
    private static BigInteger scaled(double value, int digits) {
        long bits = Double.doubleToRawLongBits(value);
        long fraction = bits & (1L << 52) - 1;
        int exponent = (int) (bits >>> 52) & 0x7ff;
        long whole = exponent == 0 ? fraction : fraction | 1L << 52;
        BigInteger size = BigInteger.valueOf(whole).shiftLeft(Math.max(1, exponent) - 1075 + digits);
        return bits < 0 ? size.negate() : size;
    }

    /** The nearest double. */
    double sin() {
        return round(sine);
    }

    /** The nearest double. */
    double cos() {
        return round(cosine);
    }

    BigInteger sine() {
        return sine;
    }

    /** How far a sum of two doubles is from the sine. */
    double distanceFromSine(double head, double rest) {
        return distance(sine, head, rest);
    }

    /** How far a sum of two doubles is from the cosine. */
    double distanceFromCosine(double head, double rest) {
        return distance(cosine, head, rest);
    }

    private double distance(BigInteger value, double head, double rest) {
        BigInteger sum = scaled(head, digits).add(scaled(rest, digits));
        return Math.scalb(value.subtract(sum).abs().doubleValue(), -digits);
    }

    /** How near the sine is to a double or the middle of two: the logarithm, base 2, of a share of their distance. */
    double nearnessOfSine() {
        return nearness(sine);
    }

    /** Returns the nearness of the cosine. */
    double nearnessOfCosine() {
        return nearness(cosine);
    }

    private static double nearness(BigInteger value) {
        int cut = value.abs().bitLength() - 54;
        BigInteger above = value.abs().mod(BigInteger.ONE.shiftLeft(cut));
        BigInteger nearness = above.min(BigInteger.ONE.shiftLeft(cut).subtract(above));
        return Math.log(nearness.doubleValue()) / Math.log(2) - cut - 1;
    }

    /** Half up; a tie has to be far. */
    private double round(BigInteger value) {
        BigInteger size = value.abs();
        int cut = Math.max(size.bitLength() - 53, digits - 1074);
        BigInteger whole = size.shiftRight(cut);
        BigInteger above = size.subtract(whole.shiftLeft(cut)).subtract(BigInteger.ONE.shiftLeft(cut - 1));
        if (above.abs().compareTo(DOUBT) < 0 && size.signum() != 0) {
            throw new AssertionError("not decided with " + digits + " digits");
        }
        double result = Math.scalb((double) (whole.longValue() + (above.signum() > 0 ? 1 : 0)), cut - digits);
        return value.signum() < 0 ? -result : result;
    }
}
