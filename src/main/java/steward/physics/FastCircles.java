package steward.physics;

import steward.numerics.DoubleDouble;
import steward.numerics.ErrorFree;

/*
 * The sums of ExactCircles, in the same order and with the same bounds, but with the parts of a number in local
 * variables, where nothing has cancelled: 12, 20 and 40 units of u^2 of the terms are then below 2^-64 of b, c and D.
 */

/**
 * The ordinary case of {@link ExactCircles#first}: two of ordinary size that clearly overlap, or approach from clearly
 * apart and meet clearly, in double-double. Everything else is left to {@link ExactCircles}.
 */
final class FastCircles {

    /** Of the terms of a sum: what is larger has lost less than 36 bits to cancellation. */
    private static final double CANCELLED = 0x1p-36;
    private static final double SMALLEST = 0x1p-300;
    private static final double LARGEST = 0x1p300;

    private FastCircles() {
    }

    /**
     * When two bodies first touch, or react because they do.
     *
     * @param separating whether two that touch react even if they do not approach
     * @return false if this is not the ordinary case: then nothing is said
     */
    static boolean first(Bodies bodies, int i, int j, boolean separating, DoubleDouble time) {
        double dx = bodies.x[i] - bodies.x[j];
        double dy = bodies.y[i] - bodies.y[j];
        double vx = bodies.vx[i] - bodies.vx[j];
        double vy = bodies.vy[i] - bodies.vy[j];
        double s = bodies.radius[i] + bodies.radius[j];
        double xvx = dx * vx;
        double yvy = dy * vy;
        double b = xvx + yvy;
        double xx = dx * dx;
        double yy = dy * dy;
        double ss = s * s;
        double squared = xx + yy;
        double c = squared - ss;
        double least = CANCELLED * (squared + ss) + SMALLEST;
        boolean approach = -b > CANCELLED * (Math.abs(xvx) + Math.abs(yvy)) + SMALLEST;
        if (c < -least && (approach || separating)) {
            time.set(0);
            return true;
        }
        double a = vx * vx + vy * vy;
        if (!(approach && c > least && a > SMALLEST && a < LARGEST && ss > SMALLEST && squared < LARGEST)) {
            return false;
        }
        double dxLow = ErrorFree.sumError(bodies.x[i], -bodies.x[j], dx);
        double dyLow = ErrorFree.sumError(bodies.y[i], -bodies.y[j], dy);
        double vxLow = ErrorFree.sumError(bodies.vx[i], -bodies.vx[j], vx);
        double vyLow = ErrorFree.sumError(bodies.vy[i], -bodies.vy[j], vy);
        double sLow = ErrorFree.sumError(bodies.radius[i], bodies.radius[j], s);
        double ssError = ErrorFree.productError(s, s, ss);
        double bLow = ErrorFree.sumError(xvx, yvy, b) + (ErrorFree.productError(dx, vx, xvx)
            + ErrorFree.productError(dy, vy, yvy)) + ((dx * vxLow + dxLow * vx) + (dy * vyLow + dyLow * vy));
        double cLow = ErrorFree.sumError(squared, -ss, c) + (ErrorFree.sumError(xx, yy, squared)
            + (ErrorFree.productError(dx, dx, xx) + ErrorFree.productError(dy, dy, yy) - ssError))
            + 2 * (dx * dxLow + dy * dyLow - s * sLow);
        double cSum = c + cLow;
        double bSum = b + bLow;
        return meet(dx, dxLow, dy, dyLow, vx, vxLow, vy, vyLow, ss, ssError + 2 * s * sLow, bSum,
            ErrorFree.fastSumError(b, bLow, bSum), cSum, ErrorFree.fastSumError(c, cLow, cSum), time);
    }

    /** By the discriminant a s^2 - (d x v)^2. */
    private static boolean meet(double dx, double dxLow, double dy, double dyLow, double vx, double vxLow,
                                double vy, double vyLow, double ss, double ssLow, double b, double bLow,
                                double c, double cLow, DoubleDouble time) {
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
        if (!(d > CANCELLED * (size * size + ass))) {
            return false;
        }
        double aLow = ErrorFree.sumError(vxx, vyy, a) + (ErrorFree.productError(vx, vx, vxx)
            + ErrorFree.productError(vy, vy, vyy) + 2 * (vx * vxLow + vy * vyLow));
        double crossLow = ErrorFree.sumError(xvy, -yvx, cross)
            + (ErrorFree.productError(dx, vy, xvy) - ErrorFree.productError(dy, vx, yvx))
            + ((dx * vyLow + dxLow * vy) - (dy * vxLow + dyLow * vx));
        double dLow = ErrorFree.sumError(ass, -crossSquared, d)
            + ((ErrorFree.productError(a, ss, ass) + (a * ssLow + aLow * ss))
            - (ErrorFree.productError(cross, cross, crossSquared) + 2 * cross * crossLow));
        double dSum = d + dLow;
        divide(c, cLow, dSum, ErrorFree.fastSumError(d, dLow, dSum), b, bLow, time);
        return true;
    }

    /** c / (sqrt D - b). */
    private static void divide(double c, double cLow, double d, double dLow, double b, double bLow,
                               DoubleDouble time) {
        double root = Math.sqrt(d);
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
