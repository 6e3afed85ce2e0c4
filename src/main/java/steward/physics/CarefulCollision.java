package steward.physics;

import steward.numerics.ErrorFree;

/*
 * Along a vector d from a to b, of any length, an impact with restitution e changes the velocities by
 *
 *     va' = va - (1 + e) sb q d,   vb' = vb + (1 + e) sa q d,   q = (va - vb).d / d.d,   sb = mb / (ma + mb) = 1 - sa.
 *
 * In plain doubles the energy of an elastic impact is off by the relative error of (1 + e) s q times what is exchanged,
 * some units of u = 2^-53. That of 1 / m or of s is the same at every impact of the same two, so that it adds up,
 * impact after impact; the others go as often one way as the other and grow with the root of the number. So q, s and
 * their products carry what was rounded off (two doubles each, the second good to some u^2), and a velocity is rounded
 * once, when it is stored. That d is rounded does not matter: impulse and approach are measured along the same d.
 *
 * The larger mass's share s = L / (L + S) is at least 1/2: 1 - RN(s) is exact, and with what s has left over it is the
 * smaller's.
 */

/**
 * The reactions of {@link Collision} with the roundings of the impulse put back, for laws without a minimum impulse:
 * the energy of a gas of elastic discs is off by the rounding of stored velocities alone, which does not drift; and a
 * bounce off an upright or level wall is the exact negative.
 */
final class CarefulCollision extends Collision {

    private double high;
    private double low;

    CarefulCollision(ImpactLaw law, Wall[] walls) {
        super(law, walls);
    }

    @Override
    void pushPair(Bodies bodies, int a, int b, double nx, double ny, double restitution, double impulse) {
        project(bodies.vx[a], bodies.vx[b], bodies.vy[a], bodies.vy[b], nx, ny, restitution);
        double massA = bodies.mass[a];
        double massB = bodies.mass[b];
        boolean heavyB = massB >= massA;
        double large = heavyB ? massB : massA;
        double small = heavyB ? massA : massB;
        double share = 1;
        double rest = 0;
        if (large < Double.POSITIVE_INFINITY) {
            double sum = large + small;
            share = large / sum;
            double back = share * sum;
            rest = (((large - back) - ErrorFree.productError(share, sum, back))
                - share * ErrorFree.fastSumError(large, small, sum)) / sum;
        }
        push(bodies, heavyB ? a : b, heavyB ? -share : share, heavyB ? -rest : rest, nx, ny);
        push(bodies, heavyB ? b : a, heavyB ? 1 - share : share - 1, heavyB ? -rest : rest, nx, ny);
    }

    @Override
    void pushOffWall(Bodies bodies, int a, double nx, double ny, double restitution, double impulse) {
        if (wallsHaveMinimum) {
            super.pushOffWall(bodies, a, nx, ny, restitution, impulse);
            return;
        }
        project(bodies.vx[a], 0, bodies.vy[a], 0, nx, ny, restitution);
        push(bodies, a, -1, 0, nx, ny);
    }

    /** (1 + e) q. */
    private void project(double vax, double vbx, double vay, double vby, double dx, double dy, double restitution) {
        double vx = vax - vbx;
        double vy = vay - vby;
        double alongX = vx * dx;
        double alongY = vy * dy;
        double along = alongX + alongY;
        double alongLow = ErrorFree.sumError(alongX, alongY, along)
            + (ErrorFree.productError(vx, dx, alongX) + ErrorFree.productError(vy, dy, alongY)
            + (ErrorFree.sumError(vax, -vbx, vx) * dx + ErrorFree.sumError(vay, -vby, vy) * dy));
        double xx = dx * dx;
        double yy = dy * dy;
        double squared = xx + yy;
        double squaredLow = ErrorFree.sumError(xx, yy, squared)
            + (ErrorFree.productError(dx, dx, xx) + ErrorFree.productError(dy, dy, yy));
        double quotient = along / squared;
        double back = quotient * squared;
        double rest = ((along - back) - ErrorFree.productError(quotient, squared, back))
            + (alongLow - quotient * squaredLow);
        double factor = 1 + restitution;
        high = factor * quotient;
        low = factor * (rest / squared) + ErrorFree.productError(factor, quotient, high);
    }

    /** Velocities change by a share of what was projected, along d. */
    private void push(Bodies bodies, int body, double share, double shareLow, double dx, double dy) {
        double size = high * share;
        double sizeLow = ErrorFree.productError(high, share, size) + (high * shareLow + low * share);
        bodies.vx[body] = added(bodies.vx[body], size, sizeLow, dx);
        bodies.vy[body] = added(bodies.vy[body], size, sizeLow, dy);
    }

    private static double added(double velocity, double size, double sizeLow, double along) {
        double change = size * along;
        double sum = velocity + change;
        return sum + (ErrorFree.sumError(velocity, change, sum)
            + (ErrorFree.productError(size, along, change) + sizeLow * along));
    }
}
