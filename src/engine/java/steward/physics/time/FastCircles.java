package steward.physics.time;

import steward.numerics.DoubleDouble;
import steward.numerics.ErrorFree;

/*
 * The values of CircleTime by CircleSums, in local variables, and only where b and c have not cancelled: 12 and 20
 * units of u^2 = 2^-106 of the terms are then below 2^-65 of them.
 *
 * D may cancel much further, at grazing impacts and near misses: it is off by less than 40 u^2 S, with S = a
 * s^2 + (|dx vy| + |dy vx|)^2. Where |D| > 2^-96 S = 1024 u^2 S its sign is certain. An impact needs more: its impulse
 * is proportional to sqrt D, so the relative error of D enters the impulse through the time of impact. Therefore a time
 * for an impulse is given only where D > 2^-36 S.
 *
 * A caller that needs only the decision and the time can have both from D > 2^-96 S on. The error of D moves
 * t = c / (sqrt D - b) by no more, relatively, than
 *
 *     error of sqrt D / (sqrt D - b)  <  40 u^2 S / (2 sqrt D (sqrt D - b)) * (1 + 2^-4),
 *
 * which is below 2^-65 where sqrt D (sqrt D - b) > 2^-36 S: the closer to tangent, the smaller D is compared with b.
 */

/**
 * The clear cases of {@link ExactCircles#firstTouch}, computed faster in double-double. Numbers have ordinary size, and
 * the pair clearly overlaps, clearly separates, or is clearly apart, approaches and clearly meets or misses. Everything
 * else is left to {@link ExactCircles}.
 */
final class FastCircles {

    /** Relative to the terms of a sum: a result above this has lost less than 36 bits to cancellation. */
    private static final double CANCELLED = 0x1p-36;
    /**
     * Relative to the terms of D: from here on the sign of D is certain, and D is accurate enough for a time of about
     * 64 bits.
     */
    static final double COARSE = 0x1p-96;
    /** From here on D is accurate enough for the impulse that follows from the time. */
    static final double FINE = CANCELLED;
    private static final double SMALLEST = 0x1p-300;
    private static final double LARGEST = 0x1p300;

    /** Result of {@link #firstTouch}: not a clear case. */
    static final int UNDECIDED = 0;
    /** Result of {@link #firstTouch}: there is an impact, at the time given. */
    static final int IMPACT = 1;
    /** Result of {@link #firstTouch}: there is no impact. */
    static final int NONE = 2;

    /**
     * The time at which two circles first touch, or 0 if they touch and react.
     *
     * @param separating whether a touching pair reacts even if it does not approach
     * @param grade      the accuracy needed, {@link #COARSE} or {@link #FINE}
     * @param time       receives the time of an {@link #IMPACT}; otherwise unchanged
     * @return {@link #UNDECIDED}, {@link #IMPACT} or {@link #NONE}
     */
    static int firstTouch(double x1, double x2, double y1, double y2, double vx1, double vx2, double vy1, double vy2,
                     double r1, double r2, boolean separating, double grade, DoubleDouble time) {
        double dx = x1 - x2;
        double dy = y1 - y2;
        double vx = vx1 - vx2;
        double vy = vy1 - vy2;
        double s = r1 + r2;
        double xvx = dx * vx;
        double yvy = dy * vy;
        double b = xvx + yvy;
        double xx = dx * dx;
        double yy = dy * dy;
        double ss = s * s;
        double squared = xx + yy;
        double c = squared - ss;
        double least = CANCELLED * (squared + ss) + SMALLEST;
        double leastB = CANCELLED * (Math.abs(xvx) + Math.abs(yvy)) + SMALLEST;
        if (c < -least && (-b > leastB || separating)) {
            time.set(0);
            return IMPACT;
        }
        if (b > leastB && (c > least || !separating)) {
            return NONE;
        }
        double a = vx * vx + vy * vy;
        if (!(-b > leastB && c > least && a > SMALLEST && a < LARGEST && ss > SMALLEST && squared < LARGEST)) {
            return UNDECIDED;
        }
        double dxLow = ErrorFree.sumError(x1, -x2, dx);
        double dyLow = ErrorFree.sumError(y1, -y2, dy);
        double vxLow = ErrorFree.sumError(vx1, -vx2, vx);
        double vyLow = ErrorFree.sumError(vy1, -vy2, vy);
        double sLow = ErrorFree.sumError(r1, r2, s);
        double bLow = CircleSums.dot(dx, dxLow, vx, vxLow, dy, dyLow, vy, vyLow, xvx, yvy, b);
        double cLow = CircleSums.excess(dx, dxLow, dy, dyLow, s, sLow, xx, yy, ss, squared, c);
        double cSum = c + cLow;
        double bSum = b + bLow;
        return byDiscriminant(dx, dxLow, dy, dyLow, vx, vxLow, vy, vyLow, ss, CircleSums.square(s, sLow, ss),
            bSum, ErrorFree.fastSumError(b, bLow, bSum), cSum, ErrorFree.fastSumError(c, cLow, cSum), grade, time);
    }

    /** Decides by the discriminant a s^2 - (d x v)^2. */
    private static int byDiscriminant(double dx, double dxLow, double dy, double dyLow, double vx, double vxLow,
                                double vy, double vyLow, double ss, double ssLow, double b, double bLow,
                                double c, double cLow, double grade, DoubleDouble time) {
        double vxx = vx * vx;
        double vyy = vy * vy;
        double a = vxx + vyy;
        double xvy = dx * vy;
        double yvx = dy * vx;
        double cross = xvy - yvx;
        double ass = a * ss;
        double crossSquared = cross * cross;
        double d = ass - crossSquared;
        double size = Math.abs(xvy) + Math.abs(yvx);
        double terms = size * size + ass;
        if (d < -CANCELLED * terms) {
            return NONE;
        }
        double aLow = CircleSums.squares(vx, vxLow, vy, vyLow, vxx, vyy, a);
        double crossLow = CircleSums.cross(dx, dxLow, vy, vyLow, dy, dyLow, vx, vxLow, xvy, yvx, cross);
        double dLow = CircleSums.discriminant(a, aLow, ss, ssLow, cross, crossLow, ass, crossSquared, d);
        double dSum = d + dLow;
        if (!(dSum > grade * terms)) {
            return dSum < -COARSE * terms ? NONE : UNDECIDED;
        }
        double root = Math.sqrt(dSum);
        if (!(root * (root - b) > CANCELLED * terms)) {
            return UNDECIDED;
        }
        divide(c, cLow, dSum, ErrorFree.sumError(d, dLow, dSum), root, b, bLow, time);
        return IMPACT;
    }

    /** c / (sqrt D - b). */
    private static void divide(double c, double cLow, double d, double dLow, double root, double b, double bLow,
                               DoubleDouble time) {
        double square = root * root;
        double rootLow = (((d - square) - ErrorFree.productError(root, root, square)) + dLow) / (2 * root);
        double sum = root - b;
        double sumLow = ErrorFree.sumError(root, -b, sum) + (rootLow - bLow);
        double quotient = c / sum;
        double back = quotient * sum;
        double rest = ((c - back) - ErrorFree.productError(quotient, sum, back)) + (cLow - quotient * sumLow);
        time.setFastSum(quotient, rest / sum);
    }
}
