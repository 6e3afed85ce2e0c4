package steward.physics.time;

import steward.numerics.DoubleDouble;
import steward.numerics.ErrorFree;
import steward.physics.Bodies;

/*
 * Of the values of CircleTime, three are subject to cancellation: b when the path is nearly perpendicular to d, c close
 * to contact, D at a grazing impact. With the errors of CircleSums added they are as if computed with 106 bits and
 * rounded once: relative error at most u + k u^2 M / |value| with M the sum of magnitudes and k a small number, at most
 * 4 for b and c; Kahan's a b - c d is the case of two products (C.-P. Jeannerod, N. Louvet, J.-M. Muller, "Further
 * Analysis of Kahan's Algorithm for the Accurate Computation of 2x2 Determinants", 2013, theorem 1.1: 2 u always). D
 * is the difference of two products of such double-double values, with k at most 24.
 *
 * While M / |value| < 2^46, the second terms are below u / 4. Then sqrt D is off by 0.63 u + u, b by 1.25 u, and as
 * both summands of sqrt D - b are positive, that by 1.63 u + u, c by 1.25 u, and with the division t by at most
 * 1.63 + 1 + 1.25 + 1 < 5 u: at most five units in the last place, whatever cancels.
 *
 * Whether an impact is before the end of the turn cannot be told from a time that is off by that much. With e = d + v l
 * after the time l that is left, it is if e.e <= s^2 then, or if they have passed each other, e.v >= 0: signs of sums
 * of products of double-doubles, as c and b.
 */

/**
 * Time of impact of two circles with the rounding errors of its differences, products and sums added back. So a path is
 * judged as given, also if it grazes by some units in the last place of the coordinates. The error is at most 5 units
 * in the last place, unless the gap is below 2^-46 of the distance or the path grazes as closely; then the decision can
 * still be wrong. Products of the inputs, up to the fourth power, have to be in the range of {@link ErrorFree}: lengths
 * and speeds from 1e-60 to 1e60.
 *
 * <p>If separating pairs react, differences are rounded first, as the push-out sees them: otherwise a pair could react
 * again and again.
 */
public final class CompensatedCircles extends CircleTime {

    /** Times this near the end of the turn are compared with it by the places then. */
    private static final double NEAR_END = 0x1p-30;

    private final DoubleDouble left = new DoubleDouble();
    private final DoubleDouble vx = new DoubleDouble();
    private final DoubleDouble vy = new DoubleDouble();
    private final DoubleDouble ex = new DoubleDouble();
    private final DoubleDouble ey = new DoubleDouble();

    @Override
    public double until(double x1, double x2, double y1, double y2, double vx1, double vx2, double vy1, double vy2,
                        double r1, double r2, boolean separatingReact) {
        return separatingReact
            ? super.until(x1, x2, y1, y2, vx1, vx2, vy1, vy2, r1, r2, separatingReact)
            : circles(x1, x2, y1, y2, vx1, vx2, vy1, vy2, r1, r2);
    }

    @Override
    public double untilInTurn(double x1, double x2, double y1, double y2, double vx1, double vx2, double vy1,
                              double vy2, double r1, double r2, double start) {
        double until = until(x1, x2, y1, y2, vx1, vx2, vy1, vy2, r1, r2, false);
        double end = 1 - start;
        if (!(Math.abs(until - end) <= NEAR_END)) {
            return until <= end ? until : NEVER;
        }
        left.setDifference(1, start);
        ex.set(vx.setDifference(vx1, vx2)).multiply(left).add(-x2).add(x1);
        ey.set(vy.setDifference(vy1, vy2)).multiply(left).add(-y2).add(y1);
        return haveMet(r1, r2) ? Math.min(until, end) : NEVER;
    }

    /** True if circles at e with velocity v touch or have passed each other. */
    private boolean haveMet(double r1, double r2) {
        double touch = r1 + r2;
        double xx = ex.high() * ex.high();
        double yy = ey.high() * ey.high();
        double ss = touch * touch;
        double squared = xx + yy;
        double excess = squared - ss;
        return excess + CircleSums.excess(ex.high(), ex.low(), ey.high(), ey.low(), touch,
            ErrorFree.sumError(r1, r2, touch), xx, yy, ss, squared, excess) <= 0
            || dot(ex.high(), ex.low(), vx.high(), vx.low(), ey.high(), ey.low(), vy.high(), vy.low()) >= 0;
    }

    @Override
    double until(double dx, double dy, double dvx, double dvy, double touch) {
        return circles(dx, 0, dy, 0, dvx, 0, dvy, 0, touch, 0);
    }

    /** @return 0 for an impact now */
    static double circles(double x1, double x2, double y1, double y2, double vx1, double vx2, double vy1, double vy2,
                          double r1, double r2) {
        double dx = x1 - x2;
        double dxLow = ErrorFree.sumError(x1, -x2, dx);
        double dy = y1 - y2;
        double dyLow = ErrorFree.sumError(y1, -y2, dy);
        double vx = vx1 - vx2;
        double vxLow = ErrorFree.sumError(vx1, -vx2, vx);
        double vy = vy1 - vy2;
        double vyLow = ErrorFree.sumError(vy1, -vy2, vy);
        double touch = r1 + r2;
        double touchLow = ErrorFree.sumError(r1, r2, touch);
        double b = dot(dx, dxLow, vx, vxLow, dy, dyLow, vy, vyLow);
        if (!(b < 0)) {
            return NEVER;
        }
        double xx = dx * dx;
        double yy = dy * dy;
        double ss = touch * touch;
        double squared = xx + yy;
        double excess = squared - ss;
        double c = excess + CircleSums.excess(dx, dxLow, dy, dyLow, touch, touchLow, xx, yy, ss, squared, excess);
        if (c <= 0) {
            return 0;
        }
        double discriminant = discriminant(dx, dxLow, dy, dyLow, vx, vxLow, vy, vyLow, ss,
            CircleSums.square(touch, touchLow, ss));
        return discriminant > 0 ? c / (Math.sqrt(discriminant) - b) : NEVER;
    }

    /** True if two bodies approach, as {@link #circles} judges it. */
    public static boolean areApproaching(Bodies bodies, int i, int j) {
        double dx = bodies.x[i] - bodies.x[j];
        double dy = bodies.y[i] - bodies.y[j];
        double vx = bodies.vx[i] - bodies.vx[j];
        double vy = bodies.vy[i] - bodies.vy[j];
        return dot(dx, ErrorFree.sumError(bodies.x[i], -bodies.x[j], dx),
            vx, ErrorFree.sumError(bodies.vx[i], -bodies.vx[j], vx),
            dy, ErrorFree.sumError(bodies.y[i], -bodies.y[j], dy),
            vy, ErrorFree.sumError(bodies.vy[i], -bodies.vy[j], vy)) < 0;
    }

    private static double dot(double p, double pLow, double q, double qLow, double r, double rLow, double s,
                              double sLow) {
        double first = p * q;
        double second = r * s;
        double sum = first + second;
        return sum + CircleSums.dot(p, pLow, q, qLow, r, rLow, s, sLow, first, second, sum);
    }

    /** v.v s^2 - (d x v)^2; the sum of the cross product is rounded to two doubles first. */
    private static double discriminant(double dx, double dxLow, double dy, double dyLow, double vx, double vxLow,
                                       double vy, double vyLow, double ss, double ssLow) {
        double vxx = vx * vx;
        double vyy = vy * vy;
        double a = vxx + vyy;
        double aLow = CircleSums.squares(vx, vxLow, vy, vyLow, vxx, vyy, a);
        double xvy = dx * vy;
        double yvx = dy * vx;
        double difference = xvy - yvx;
        double rest = ErrorFree.sumError(xvy, -yvx, difference)
            + (ErrorFree.productError(dx, vy, xvy) - ErrorFree.productError(dy, vx, yvx)
            + ((dx * vyLow + dxLow * vy) - (dy * vxLow + dyLow * vx)));
        double cross = difference + rest;
        double crossLow = ErrorFree.sumError(difference, rest, cross);
        double ass = a * ss;
        double crossSquared = cross * cross;
        double discriminant = ass - crossSquared;
        return discriminant + CircleSums.discriminant(a, aLow, ss, ssLow, cross, crossLow, ass, crossSquared,
            discriminant);
    }
}
