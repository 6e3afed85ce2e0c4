package steward.physics.time;

import steward.numerics.ErrorFree;
import steward.physics.Bodies;

/*
 * With u = 2^-53, d from centre to centre, v the relative velocity and s the touching distance as given (their own
 * rounding is not considered), a circle is hit when D = a s^2 - (d x v)^2 > 0, at t = c / (sqrt D - b), where a = v.v,
 * b = d.v < 0, c = d.d - s^2 > 0; see TimeOfImpact. Three of these are subject to cancellation: b when the path is
 * nearly perpendicular to d, c close to contact, D at a grazing impact.
 *
 * Each is a sum of products. A product and its error are two doubles that sum to it exactly, so the sum of the rounded
 * products (with the errors of that sum) and the sum of all errors together are the value as if computed with 106 bits
 * and rounded once: relative error at most u + k u^2 M / |value| with M the sum of magnitudes and k a small number, at
 * most 4 for b and c; Kahan's a b - c d is the case of two products (C.-P. Jeannerod, N. Louvet, J.-M. Muller, "Further
 * Analysis of Kahan's Algorithm for the Accurate Computation of 2x2 Determinants", 2013, theorem 1.1: 2 u always). D
 * is the difference of two products of such double-double values, with k at most 24.
 *
 * While M / |value| < 2^46, the second terms are below u / 4. Then sqrt D is off by 0.63 u + u, b by 1.25 u, and as
 * both summands of sqrt D - b are positive, that by 1.63 u + u, c by 1.25 u, and with the division t by at most
 * 1.63 + 1 + 1.25 + 1 < 5 u: at most five units in the last place, whatever cancels.
 */

/**
 * Time of impact of two circles with the rounding errors of its products and sums added back: the error is at most 5
 * units in the last place for the vectors as given, unless the gap is below 2^-46 of the distance or the path grazes as
 * closely; there the decision can still be wrong. Products of the inputs, up to the fourth power, have to be in the
 * range of {@link ErrorFree}: lengths and speeds from 1e-60 to 1e60.
 */
public final class CompensatedTime {

    private static final double NEVER = Double.POSITIVE_INFINITY;

    private CompensatedTime() {
    }

    /** Parameters and result as in {@link TimeOfImpact#circles}. */
    static double circles(double dx, double dy, double dvx, double dvy, double touch) {
        double b = dot(dx, dvx, dy, dvy, 0);
        if (!(b < 0)) {
            return NEVER;
        }
        double c = excess(dx, dy, touch, 0);
        if (c <= 0) {
            return 0;
        }
        double discriminant = discriminant(dx, 0, dy, 0, dvx, 0, dvy, 0, touch, 0);
        return discriminant > 0 ? c / (Math.sqrt(discriminant) - b) : NEVER;
    }

    /**
     * The same for two circles, of which the differences are taken with their rounding errors: so a path is judged as
     * given, also where it grazes by some units in the last place of the coordinates.
     *
     * @return 0 for an impact now
     */
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
        double b = dot(dx, vx, dy, vy, dx * vxLow + dxLow * vx + (dy * vyLow + dyLow * vy));
        if (!(b < 0)) {
            return NEVER;
        }
        double c = excess(dx, dy, touch, 2 * (dx * dxLow + dy * dyLow - touch * touchLow));
        if (c <= 0) {
            return 0;
        }
        double discriminant = discriminant(dx, dxLow, dy, dyLow, vx, vxLow, vy, vyLow, touch, touchLow);
        return discriminant > 0 ? c / (Math.sqrt(discriminant) - b) : NEVER;
    }

    /** Whether two bodies approach, as {@link #circles} judges it. */
    public static boolean areApproaching(Bodies bodies, int i, int j) {
        double dx = bodies.x[i] - bodies.x[j];
        double dy = bodies.y[i] - bodies.y[j];
        double vx = bodies.vx[i] - bodies.vx[j];
        double vy = bodies.vy[i] - bodies.vy[j];
        double dxLow = ErrorFree.sumError(bodies.x[i], -bodies.x[j], dx);
        double dyLow = ErrorFree.sumError(bodies.y[i], -bodies.y[j], dy);
        double vxLow = ErrorFree.sumError(bodies.vx[i], -bodies.vx[j], vx);
        double vyLow = ErrorFree.sumError(bodies.vy[i], -bodies.vy[j], vy);
        return dot(dx, vx, dy, vy, dx * vxLow + dxLow * vx + (dy * vyLow + dyLow * vy)) < 0;
    }

    /** p q + r s, and what the low parts of these add. */
    private static double dot(double p, double q, double r, double s, double lows) {
        double first = p * q;
        double second = r * s;
        double sum = first + second;
        return sum + (ErrorFree.sumError(first, second, sum)
            + (ErrorFree.productError(p, q, first) + ErrorFree.productError(r, s, second)) + lows);
    }

    /** x^2 + y^2 - s^2, and what the low parts of these add. */
    private static double excess(double x, double y, double s, double lows) {
        double xx = x * x;
        double yy = y * y;
        double ss = s * s;
        double sum = xx + yy;
        double difference = sum - ss;
        return difference + (ErrorFree.sumError(sum, -ss, difference) + (ErrorFree.sumError(xx, yy, sum)
            + (ErrorFree.productError(x, x, xx) + ErrorFree.productError(y, y, yy)
            - ErrorFree.productError(s, s, ss))) + lows);
    }

    /** v.v s^2 - (d x v)^2. */
    private static double discriminant(double dx, double dxLow, double dy, double dyLow, double dvx, double dvxLow,
                                       double dvy, double dvyLow, double touch, double touchLow) {
        double xx = dvx * dvx;
        double yy = dvy * dvy;
        double a = xx + yy;
        double aLow = ErrorFree.sumError(xx, yy, a)
            + (ErrorFree.productError(dvx, dvx, xx) + ErrorFree.productError(dvy, dvy, yy)
            + 2 * (dvx * dvxLow + dvy * dvyLow));
        double ss = touch * touch;
        double ssLow = ErrorFree.productError(touch, touch, ss) + 2 * touch * touchLow;
        double first = a * ss;
        double firstLow = ErrorFree.productError(a, ss, first) + (a * ssLow + aLow * ss);
        double xy = dx * dvy;
        double yx = dy * dvx;
        double difference = xy - yx;
        double differenceLow = ErrorFree.sumError(xy, -yx, difference)
            + (ErrorFree.productError(dx, dvy, xy) - ErrorFree.productError(dy, dvx, yx)
            + ((dx * dvyLow + dxLow * dvy) - (dy * dvxLow + dyLow * dvx)));
        double cross = difference + differenceLow;
        double crossLow = ErrorFree.sumError(difference, differenceLow, cross);
        double second = cross * cross;
        double secondLow = ErrorFree.productError(cross, cross, second) + 2 * cross * crossLow;
        double discriminant = first - second;
        return discriminant + (ErrorFree.sumError(first, -second, discriminant) + (firstLow - secondLow));
    }
}
