package steward.physics.impulse;

import steward.numerics.ErrorFree;
import steward.physics.Bodies;
import steward.physics.time.CircleSums;

/*
 * Along a vector d from a to b, of any length, an impact with restitution e changes the velocities by
 *
 *     va' = va - (1 + e) sb q d,   vb' = vb + (1 + e) sa q d,   q = (va - vb).d / d.d,   sb = mb / (ma + mb) = 1 - sa.
 *
 * In plain doubles the energy of an elastic impact is off by the relative error of (1 + e) s q times the energy
 * exchanged, some units of u = 2^-53. The error of 1 / m or of s is the same at every impact of the same pair, so it
 * adds up linearly; the others have random signs and grow with the square root of the number of impacts. So q, s and
 * their products carry their rounding errors (two doubles each, the second accurate to some u), and a velocity is
 * rounded once, when it is stored. Impulse and approach are measured along the same d, so the rounding of d does not
 * affect the energy.
 */

/** Register of a double-double for the factors of an impulse: operations replace it by their result. */
final class ImpulseRegister {

    /** Result of the last operation: the sum of both, accurate to some units of u^2. */
    double high;
    double low;
    /** d.d of the last projection. */
    double squared;
    double squaredLow;

    /** q = (va - vb).d / d.d. */
    void project(double vax, double vbx, double vay, double vby, double dx, double dxLow, double dy, double dyLow) {
        double vx = vax - vbx;
        double vy = vay - vby;
        double alongX = vx * dx;
        double alongY = vy * dy;
        double along = alongX + alongY;
        double alongLow = CircleSums.dot(vx, ErrorFree.sumError(vax, -vbx, vx), dx, dxLow,
            vy, ErrorFree.sumError(vay, -vby, vy), dy, dyLow, alongX, alongY, along);
        double xx = dx * dx;
        double yy = dy * dy;
        squared = xx + yy;
        squaredLow = CircleSums.squares(dx, dxLow, dy, dyLow, xx, yy, squared);
        double whole = along + alongLow;              // after cancellation the error is not small against the sum
        divide(whole, ErrorFree.sumError(along, alongLow, whole), squared, squaredLow);
    }

    void divide(double a, double aLow, double b, double bLow) {
        double quotient = a / b;
        double back = quotient * b;
        high = quotient;
        low = (((a - back) - ErrorFree.productError(quotient, b, back)) + (aLow - quotient * bLow)) / b;
    }

    void multiply(double a, double aLow, double b, double bLow) {
        high = a * b;
        low = ErrorFree.productError(a, b, high) + (a * bLow + aLow * b);
    }

    /** Multiplies the last result by 1 + e. */
    void multiplyByOnePlus(double restitution) {
        double factor = 1 + restitution;
        multiply(high, low, factor, ErrorFree.fastSumError(1, restitution, factor));
    }

    /** Multiplies a number by mass / (mass + other), which is 1 if the mass is infinite and 0 if the other is. */
    void multiplyByMassShare(double mass, double other, double size, double sizeLow) {
        if (mass == other) {
            high = 0.5 * size;
            low = 0.5 * sizeLow;
        } else if (mass == Double.POSITIVE_INFINITY) {
            high = size;
            low = sizeLow;
        } else if (other == Double.POSITIVE_INFINITY) {
            high = 0;
            low = 0;
        } else {
            double sum = mass + other;
            divide(mass, 0, sum, ErrorFree.sumError(mass, other, sum));
            multiply(size, sizeLow, high, low);
        }
    }

    /** Adds a multiple of d to a velocity. */
    static void addVelocity(Bodies bodies, int body, double size, double sizeLow, double dx, double dxLow, double dy,
                            double dyLow) {
        bodies.vx[body] = added(bodies.vx[body], size, sizeLow, dx, dxLow);
        bodies.vy[body] = added(bodies.vy[body], size, sizeLow, dy, dyLow);
    }

    private static double added(double velocity, double size, double sizeLow, double along, double alongLow) {
        double change = size * along;
        double sum = velocity + change;
        return sum + (ErrorFree.sumError(velocity, change, sum)
            + (ErrorFree.productError(size, along, change) + (sizeLow * along + size * alongLow)));
    }
}
