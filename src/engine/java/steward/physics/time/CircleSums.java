package steward.physics.time;

import steward.numerics.ErrorFree;

/*
 * Each value of the quadratic of CircleTime is a sum of products. A product and its error are two doubles that sum to
 * it exactly; so the rounded sum of the rounded products, and the sum of all errors together with what the low parts of
 * the factors add, are the value to some units of u^2 = 2^-106 of the terms:
 *
 *     b: 12 u^2 per |dx vx| + |dy vy|        c: 20 u^2 per d.d + s^2        D: 40 u^2 per a s^2 + (|dx vy| + |dy vx|)^2
 */

/** Rounding errors of sums of products of double-double numbers, given the rounded products and sums. */
public final class CircleSums {

    private CircleSums() { }

    /** Of p q + r s = sum, rounded, with the rounded products pq and rs. */
    public static double dot(double p, double pLow, double q, double qLow, double r, double rLow, double s,
                             double sLow, double pq, double rs, double sum) {
        return ErrorFree.sumError(pq, rs, sum) + (ErrorFree.productError(p, q, pq) + ErrorFree.productError(r, s, rs))
            + ((p * qLow + pLow * q) + (r * sLow + rLow * s));
    }

    /** Of p q - r s = difference. */
    public static double cross(double p, double pLow, double q, double qLow, double r, double rLow, double s,
                               double sLow, double pq, double rs, double difference) {
        return ErrorFree.sumError(pq, -rs, difference)
            + (ErrorFree.productError(p, q, pq) - ErrorFree.productError(r, s, rs))
            + ((p * qLow + pLow * q) - (r * sLow + rLow * s));
    }

    /** Of x^2 + y^2 = sum. */
    public static double squares(double x, double xLow, double y, double yLow, double xx, double yy, double sum) {
        return ErrorFree.sumError(xx, yy, sum) + (ErrorFree.productError(x, x, xx) + ErrorFree.productError(y, y, yy)
            + 2 * (x * xLow + y * yLow));
    }

    /** Of x^2 + y^2 - s^2 = excess, with the rounded sum of the first two. */
    static double excess(double x, double xLow, double y, double yLow, double s, double sLow, double xx, double yy,
                         double ss, double sum, double excess) {
        return ErrorFree.sumError(sum, -ss, excess) + (ErrorFree.sumError(xx, yy, sum)
            + (ErrorFree.productError(x, x, xx) + ErrorFree.productError(y, y, yy) - ErrorFree.productError(s, s, ss)))
            + 2 * (x * xLow + y * yLow - s * sLow);
    }

    /** Of s^2 = ss. */
    static double square(double s, double sLow, double ss) {
        return ErrorFree.productError(s, s, ss) + 2 * s * sLow;
    }

    /** Of a s^2 - cross^2 = D, all rounded. */
    static double discriminant(double a, double aLow, double ss, double ssLow, double cross, double crossLow,
                               double ass, double crossSquared, double discriminant) {
        return ErrorFree.sumError(ass, -crossSquared, discriminant)
            + ((ErrorFree.productError(a, ss, ass) + (a * ssLow + aLow * ss)) - square(cross, crossLow, crossSquared));
    }
}
