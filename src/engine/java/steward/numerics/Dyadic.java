package steward.numerics;

import java.math.BigInteger;

/**
 * Exact number digits * 2^exponent. Every double is one, and so are sums and products of these: for decisions that are
 * too close for other arithmetics. Allocates.
 */
public record Dyadic(BigInteger digits, int exponent) {

    public static final Dyadic ZERO = new Dyadic(BigInteger.ZERO, 0);
    private static final int FRACTION = 52;

    /** A finite double. */
    public static Dyadic of(double value) {
        if (value == 0) {
            return ZERO;
        }
        int exponent = Math.max(Math.getExponent(value), Double.MIN_EXPONENT) - FRACTION;
        long whole = (long) Math.scalb(Math.scalb(value, -exponent / 2), -exponent - -exponent / 2);
        int zeros = Long.numberOfTrailingZeros(whole);
        return new Dyadic(BigInteger.valueOf(whole >> zeros), exponent + zeros);
    }

    /** The exact difference of two doubles. */
    public static Dyadic difference(double from, double what) {
        return of(from).minus(of(what));
    }

    public Dyadic plus(Dyadic other) {
        int least = Math.min(exponent, other.exponent);
        return signum() == 0 ? other : other.signum() == 0 ? this
            : new Dyadic(digits.shiftLeft(exponent - least).add(other.digits.shiftLeft(other.exponent - least)), least);
    }

    public Dyadic minus(Dyadic other) {
        return plus(other.negate());
    }

    public Dyadic times(Dyadic other) {
        return new Dyadic(digits.multiply(other.digits), exponent + other.exponent);
    }

    public Dyadic square() {
        return times(this);
    }

    public Dyadic negate() {
        return new Dyadic(digits.negate(), exponent);
    }

    /** -1, 0 or 1. */
    public int signum() {
        return digits.signum();
    }
}
