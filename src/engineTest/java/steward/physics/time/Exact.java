package steward.physics.time;

import java.math.BigDecimal;
import java.math.MathContext;

/**
 * A second way to first touches, in decimal arithmetic of 60 digits and straight from the definitions: a moving point
 * p + v t against a circle of radius s around the origin, by way of the point of closest approach. Nothing of the
 * engine's formulas is used.
 */
public final class Exact {

    static final MathContext DIGITS = new MathContext(60);

    /** 2^-53: the largest relative error of one operation on doubles, the unit of all error bounds in these tests. */
    public static final double ULP = 0x1p-53;

    private Exact() {
    }

    static BigDecimal of(double value) {
        return new BigDecimal(value);
    }

    static BigDecimal dot(double ax, double ay, double bx, double by) {
        return of(ax).multiply(of(bx)).add(of(ay).multiply(of(by)));
    }

    static BigDecimal square(BigDecimal value) {
        return value.multiply(value);
    }

    static BigDecimal root(BigDecimal value) {
        return value.sqrt(DIGITS);
    }

    /** When the point is nearest to the origin: -(p.v) / (v.v). */
    static BigDecimal nearestTime(double x, double y, double vx, double vy) {
        return dot(x, y, vx, vy).negate().divide(dot(vx, vy, vx, vy), DIGITS);
    }

    /** The square of the distance of the line of flight from the origin, p.p - (p.v)^2 / (v.v). */
    static BigDecimal nearestSquared(double x, double y, double vx, double vy) {
        return dot(x, y, x, y).subtract(
            square(dot(x, y, vx, vy)).divide(dot(vx, vy, vx, vy), DIGITS), DIGITS);
    }

    /** The two times at which the line of flight crosses the circle, or {@code null} if it does not. */
    static BigDecimal[] crossings(double x, double y, double vx, double vy, BigDecimal s) {
        BigDecimal room = square(s).subtract(nearestSquared(x, y, vx, vy));
        if (room.signum() <= 0) {
            return null;
        }
        BigDecimal half = root(room.divide(dot(vx, vy, vx, vy), DIGITS));
        BigDecimal middle = nearestTime(x, y, vx, vy);
        return new BigDecimal[] {middle.subtract(half), middle.add(half)};
    }

    /** How far a double is from the exact value, in the value's own unit. */
    static double error(double found, BigDecimal exact) {
        return of(found).subtract(exact).abs().doubleValue();
    }
}
