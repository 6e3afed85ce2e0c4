package steward.physics.time;

import steward.numerics.ErrorFree;

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
final class CompensatedTime {

    private static final double NEVER = Double.POSITIVE_INFINITY;

    private CompensatedTime() {
    }

    /** Parameters and result as in {@link TimeOfImpact#circles}. */
    static double circles(double dx, double dy, double dvx, double dvy, double touch) {
        double b = dot(dx, dvx, dy, dvy);
        if (!(b < 0)) {
            return NEVER;
        }
        double c = excess(dx, dy, touch);
        if (c <= 0) {
            return 0;
        }
        double discriminant = discriminant(dx, dy, dvx, dvy, touch);
        return discriminant > 0 ? c / (Math.sqrt(discriminant) - b) : NEVER;
    }

    /** p q + r s. */
    private static double dot(double p, double q, double r, double s) {
        double first = p * q;
        double second = r * s;
        double sum = first + second;
        return sum + (ErrorFree.sumError(first, second, sum)
            + (ErrorFree.productError(p, q, first) + ErrorFree.productError(r, s, second)));
    }

    /** x^2 + y^2 - s^2. */
    private static double excess(double x, double y, double s) {
        double xx = x * x;
        double yy = y * y;
        double ss = s * s;
        double sum = xx + yy;
        double difference = sum - ss;
        return difference + (ErrorFree.sumError(sum, -ss, difference) + (ErrorFree.sumError(xx, yy, sum)
            + (ErrorFree.productError(x, x, xx) + ErrorFree.productError(y, y, yy)
            - ErrorFree.productError(s, s, ss))));
    }

    /** v.v s^2 - (d x v)^2. */
    private static double discriminant(double dx, double dy, double dvx, double dvy, double touch) {
        double xx = dvx * dvx;
        double yy = dvy * dvy;
        double a = xx + yy;
        double aLow = ErrorFree.sumError(xx, yy, a)
            + (ErrorFree.productError(dvx, dvx, xx) + ErrorFree.productError(dvy, dvy, yy));
        double ss = touch * touch;
        double ssLow = ErrorFree.productError(touch, touch, ss);
        double first = a * ss;
        double firstLow = ErrorFree.productError(a, ss, first) + (a * ssLow + aLow * ss);
        double xy = dx * dvy;
        double yx = dy * dvx;
        double difference = xy - yx;
        double differenceLow = ErrorFree.sumError(xy, -yx, difference)
            + (ErrorFree.productError(dx, dvy, xy) - ErrorFree.productError(dy, dvx, yx));
        double cross = difference + differenceLow;
        double crossLow = ErrorFree.sumError(difference, differenceLow, cross);
        double second = cross * cross;
        double secondLow = ErrorFree.productError(cross, cross, second) + 2 * cross * crossLow;
        double discriminant = first - second;
        return discriminant + (ErrorFree.sumError(first, -second, discriminant) + (firstLow - secondLow));
    }
}
