package steward.lab.oracle;

import java.math.BigDecimal;
import java.math.BigInteger;
import java.math.MathContext;
import java.math.RoundingMode;

/**
 * Decimal arithmetic of 64 digits for the oracle. Every double is a decimal number and is converted exactly; sums and
 * products ({@link #dot}, {@link #cross}) are exact. Only quotients, roots and stored states are rounded.
 */
public final class Decimals {

    /** Significant decimal digits of a stored state. */
    static final int COUNT = 64;
    /** Rounds to {@link #COUNT} digits. */
    static final MathContext ROUND = new MathContext(COUNT);
    /** Two numbers of a state that are nearer than this, relative to their size, differ only by rounding. */
    static final BigDecimal SAME = BigDecimal.ONE.movePointLeft(COUNT - 16);

    private Decimals() { }

    /** @throws NumberFormatException if the number is not finite */
    public static BigDecimal of(double value) {
        return new BigDecimal(value);
    }

    /** a.b, exact. */
    static BigDecimal dot(BigDecimal ax, BigDecimal ay, BigDecimal bx, BigDecimal by) {
        return ax.multiply(bx).add(ay.multiply(by));
    }

    /** a x b, exact. */
    static BigDecimal cross(BigDecimal ax, BigDecimal ay, BigDecimal bx, BigDecimal by) {
        return ax.multiply(by).subtract(ay.multiply(bx));
    }

    static BigDecimal square(BigDecimal value) {
        return value.multiply(value);
    }

    /** To 64 digits; a zero loses its accumulated scale, which would slow down all later operations. */
    static BigDecimal round(BigDecimal value) {
        return value.signum() == 0 ? BigDecimal.ZERO : value.round(ROUND);
    }

    static BigDecimal divide(BigDecimal a, BigDecimal b) {
        return a.signum() == 0 ? BigDecimal.ZERO : a.divide(b, ROUND);
    }

    /** The square root to 64 digits or a few more: the integer square root of the unscaled value with enough digits. */
    static BigDecimal root(BigDecimal value) {
        if (value.signum() == 0) {
            return BigDecimal.ZERO;
        }
        int more = 2 * COUNT + 2 - value.precision();
        int scale = value.scale() + more;
        BigInteger whole = value.setScale(scale + (scale & 1), RoundingMode.DOWN).unscaledValue();
        return new BigDecimal(whole.sqrt(), (scale + (scale & 1)) / 2);
    }

    public static BigDecimal length(BigDecimal x, BigDecimal y) {
        return root(dot(x, y, x, y));
    }

    /** True if a is at most b except for rounding; both at least 0. */
    static boolean atMost(BigDecimal a, BigDecimal b) {
        return a.compareTo(b) <= 0 || a.subtract(b).compareTo(b.multiply(SAME)) <= 0;
    }
}
