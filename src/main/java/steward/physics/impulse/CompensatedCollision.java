package steward.physics.impulse;

import steward.numerics.ErrorFree;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;
import steward.physics.Wall;
import steward.physics.time.CompensatedCircles;

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

/**
 * The reactions of {@link Collision} with the rounding errors of the impulse added back, for laws without a minimum
 * impulse: the energy of a gas of elastic discs is affected only by the rounding of stored velocities, which does not
 * drift; and an elastic bounce off a vertical or horizontal wall exactly negates a velocity component.
 */
sealed class CompensatedCollision extends Collision permits ExactCollision, CompensatedCollision.Judging {

    /** Result of the last operation: the sum of both, accurate to some units of u^2. */
    double high;
    double low;
    /** d.d of the last projection. */
    double squared;
    double squaredLow;

    CompensatedCollision(ImpactLaw law, Wall[] walls) {
        super(law, walls);
    }

    @Override
    void applyPairImpulse(Bodies bodies, int a, int b, double nx, double ny, double restitution, double impulse) {
        project(bodies.vx[a], bodies.vx[b], bodies.vy[a], bodies.vy[b], nx, 0, ny, 0);
        multiplyByOnePlus(restitution);
        double size = high;
        double sizeLow = low;
        multiplyByMassShare(bodies.mass[b], bodies.mass[a], size, sizeLow);
        addVelocity(bodies, a, -high, -low, nx, 0, ny, 0);
        multiplyByMassShare(bodies.mass[a], bodies.mass[b], size, sizeLow);
        addVelocity(bodies, b, high, low, nx, 0, ny, 0);
    }

    @Override
    void applyWallImpulse(Bodies bodies, int a, double nx, double ny, double restitution, double impulse) {
        project(bodies.vx[a], 0, bodies.vy[a], 0, nx, 0, ny, 0);
        multiplyByOnePlus(restitution);
        addVelocity(bodies, a, -high, -low, nx, 0, ny, 0);
    }

    /** q = (va - vb).d / d.d. */
    final void project(double vax, double vbx, double vay, double vby, double dx, double dxLow, double dy,
                       double dyLow) {
        double vx = vax - vbx;
        double vy = vay - vby;
        double alongX = vx * dx;
        double alongY = vy * dy;
        double along = alongX + alongY;
        double alongLow = ErrorFree.sumError(alongX, alongY, along)
            + (ErrorFree.productError(vx, dx, alongX) + ErrorFree.productError(vy, dy, alongY))
            + ((ErrorFree.sumError(vax, -vbx, vx) * dx + vx * dxLow)
            + (ErrorFree.sumError(vay, -vby, vy) * dy + vy * dyLow));
        double xx = dx * dx;
        double yy = dy * dy;
        squared = xx + yy;
        squaredLow = ErrorFree.sumError(xx, yy, squared)
            + (ErrorFree.productError(dx, dx, xx) + ErrorFree.productError(dy, dy, yy)
            + 2 * (dx * dxLow + dy * dyLow));
        double whole = along + alongLow;              // after cancellation the error is not small against the sum
        divide(whole, ErrorFree.sumError(along, alongLow, whole), squared, squaredLow);
    }

    final void divide(double a, double aLow, double b, double bLow) {
        double quotient = a / b;
        double back = quotient * b;
        high = quotient;
        low = (((a - back) - ErrorFree.productError(quotient, b, back)) + (aLow - quotient * bLow)) / b;
    }

    final void multiply(double a, double aLow, double b, double bLow) {
        high = a * b;
        low = ErrorFree.productError(a, b, high) + (a * bLow + aLow * b);
    }

    /** Multiplies the last result by 1 + e. */
    final void multiplyByOnePlus(double restitution) {
        double factor = 1 + restitution;
        multiply(high, low, factor, ErrorFree.fastSumError(1, restitution, factor));
    }

    /** Multiplies a number by mass / (mass + other), which is 1 if the mass is infinite and 0 if the other is. */
    final void multiplyByMassShare(double mass, double other, double size, double sizeLow) {
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

    /**
     * For the arithmetic {@code COMPENSATED}: a residual approach is removed until {@link CompensatedCircles} sees none
     * of it.
     */
    static final class Judging extends CompensatedCollision {

        Judging(ImpactLaw law, Wall[] walls) {
            super(law, walls);
        }

        @Override
        void removeResidualApproach(Bodies bodies, int a, int b, double nx, double ny, double speeds) {
            super.removeResidualApproach(bodies, a, b, nx, ny, speeds);
            boolean first = bodies.inverseMass[a] >= bodies.inverseMass[b];
            int body = first ? a : b;
            double step = first ? -Math.ulp(speeds) : Math.ulp(speeds);
            while (CompensatedCircles.areApproaching(bodies, a, b)) {
                bodies.vx[body] += nx * step;
                bodies.vy[body] += ny * step;
                step *= 2;
            }
        }
    }
}
