package steward.physics.time;

import java.math.BigDecimal;
import java.math.MathContext;
import steward.numerics.DoubleDouble;

/**
 * Times at which two circles touch, for {@link ExactCircles}, if the magnitudes of their numbers are too far apart for
 * doubles. The quadratic is solved in exact decimals, with roots to 50 digits. Every double is a finite decimal, and so
 * are the coefficients. It takes about a millisecond.
 */
final class WideCircles {

    private static final MathContext DIGITS = new MathContext(50);

    private final BigDecimal a;
    private final BigDecimal b;
    private final BigDecimal c;
    private final BigDecimal discriminant;

    /** Parameters as in {@link ExactCircles#load(double, double, double, double, double, double, double, double,
     * double, double)}. */
    WideCircles(double x1, double x2, double y1, double y2, double vx1, double vx2, double vy1, double vy2,
                double r1, double r2) {
        BigDecimal dx = difference(x1, x2);
        BigDecimal dy = difference(y1, y2);
        BigDecimal vx = difference(vx1, vx2);
        BigDecimal vy = difference(vy1, vy2);
        BigDecimal s = difference(r1, -r2);
        a = vx.multiply(vx).add(vy.multiply(vy));
        b = dx.multiply(vx).add(dy.multiply(vy));
        c = dx.multiply(dx).add(dy.multiply(dy)).subtract(s.multiply(s));
        discriminant = b.multiply(b).subtract(a.multiply(c));
    }

    private static BigDecimal difference(double from, double what) {
        return new BigDecimal(from).subtract(new BigDecimal(what));
    }

    /** The sign of b: -1 when the two approach. */
    int approachSign() {
        return b.signum();
    }

    /** The sign of c: 1 when the two do not touch. */
    int touchSign() {
        return c.signum();
    }

    /** As {@link ExactCircles#firstTouch} for a pair that approaches and does not touch. */
    boolean firstTouch(DoubleDouble time) {
        if (discriminant.signum() <= 0) {
            return false;
        }
        return round(c.divide(discriminant.sqrt(DIGITS).subtract(b), DIGITS), time);
    }

    /**
     * As {@link ExactCircles#lastTouch} for a point that moves, except one at the edge or outside that moves outward.
     */
    boolean lastTouch(DoubleDouble time) {
        if (discriminant.signum() <= 0) {
            return round(b.negate().divide(a, DIGITS), time);
        }
        BigDecimal root = discriminant.sqrt(DIGITS);
        return round(b.signum() <= 0 ? root.subtract(b).divide(a, DIGITS)
            : c.negate().divide(b.add(root), DIGITS), time);
    }

    /** @return whether the time is finite */
    private static boolean round(BigDecimal exact, DoubleDouble time) {
        double high = exact.doubleValue();
        if (high == Double.POSITIVE_INFINITY) {
            return false;
        }
        double low = high < 0x1p-968 ? 0 : exact.subtract(new BigDecimal(high)).doubleValue();
        time.setSum(high, low);
        return true;
    }
}
