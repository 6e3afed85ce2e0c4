package steward.physics.impulse;

import steward.numerics.DoubleDouble;
import steward.numerics.ErrorFree;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;
import steward.physics.Wall;
import steward.physics.time.ExactPairs;
import steward.physics.time.ExactWalls;
import steward.physics.time.LowParts;

/**
 * Impulses in double-double arithmetic, computed from the positions before rounding (see {@link LowParts}). All numbers
 * are two doubles each, accurate to some units of 2^-106, and impulse and new velocities are rounded once, when they
 * are stored. The stored masses are used, not their rounded inverses. A gap of up to 2^-60 of the distance counts as
 * contact: a time of impact in double-double is not more accurate.
 *
 * <p>Under a law in which only approach reacts, the rounding of positions can make a pair approach again right after
 * its impact. This happens when the cosine between normal and velocity is below the rounding of the positions relative
 * to the touching distance; if the positions are as stored, the rounding of the velocities can do so. Then, and after
 * an impact without restitution, the residual approach is removed: first by a unit in the last place of each velocity,
 * and if that is not enough, as in {@link ImpulseSolver#separate}; exact signs decide whether there is any.
 */
final class ExactSolver extends ImpulseSolver {

    private static final double TOUCH = 0x1p-60;
    /**
     * Distances between the inverse of this and this need no scaling: times any speed they are in the range of doubles.
     */
    private static final double LARGE = 0x1p20;

    /** Slower bodies are made faster by this factor for the length of an impact. */
    private static final double SLOW = 0x1p-600;
    private static final double FASTER = 0x1p500;

    private final ExactPairs pairs;
    private final ExactWalls wallTimes;
    private final LowParts lows;
    /** True if there is a minimum impulse, so that velocities follow from the impulse; and whether at walls. */
    private final boolean hasMinimum;
    private final boolean hasMinimumAtWalls;
    private final CentralImpact central = new CentralImpact();
    private final ImpulseRegister q = new ImpulseRegister();
    private final DoubleDouble normalX = new DoubleDouble();
    private final DoubleDouble normalY = new DoubleDouble();
    private final DoubleDouble first = new DoubleDouble();
    private final DoubleDouble second = new DoubleDouble();
    private final DoubleDouble work = new DoubleDouble();
    private final DoubleDouble other = new DoubleDouble();

    /** The vector from centre to centre, times 2^-scale, and its length. */
    private double dx;
    private double dxLow;
    private double dy;
    private double dyLow;
    private int scale;
    private boolean coincident;
    private double length;
    private double lengthLow;

    ExactSolver(ImpactLaw law, ExactPairs pairs, ExactWalls wallTimes, LowParts lows) {
        this.pairs = pairs;
        this.wallTimes = wallTimes;
        this.lows = lows;
        hasMinimum = law.minimumImpulse() > 0;
        hasMinimumAtWalls = hasMinimum && law.minimumImpulseAtWalls();
    }

    @Override
    void exchange(Bodies bodies, int a, int b, double restitution, Impulse rule, SolvedImpulse solved) {
        computeDirection(bodies, a, b);
        if (!hasMinimum && areSlow(bodies, a, b)) {
            exchangeSlow(bodies, a, b, restitution, rule, solved);
            return;
        }
        exchangeAlong(bodies, a, b, restitution, rule, solved);
    }

    /**
     * The light body of a pair can leave the heavy one a velocity of which the low part would underflow: velocities are
     * multiplied by a power of two, and the results divided by it.
     */
    private void exchangeSlow(Bodies bodies, int a, int b, double restitution, Impulse rule, SolvedImpulse solved) {
        multiplyVelocities(bodies, a, b, FASTER);
        exchangeAlong(bodies, a, b, restitution, rule, solved);
        multiplyVelocities(bodies, a, b, 1 / FASTER);
        solved.set(solved.impulse / FASTER, solved.energy / FASTER / FASTER);
    }

    private static boolean areSlow(Bodies bodies, int a, int b) {
        return Math.abs(bodies.vx[a]) + Math.abs(bodies.vy[a]) + Math.abs(bodies.vx[b]) + Math.abs(bodies.vy[b]) < SLOW;
    }

    private static void multiplyVelocities(Bodies bodies, int a, int b, double factor) {
        bodies.vx[a] *= factor;
        bodies.vy[a] *= factor;
        bodies.vx[b] *= factor;
        bodies.vy[b] *= factor;
    }

    private void exchangeAlong(Bodies bodies, int a, int b, double restitution, Impulse rule, SolvedImpulse solved) {
        q.project(bodies.vx[a], bodies.vx[b], bodies.vy[a], bodies.vy[b], dx, dxLow, dy, dyLow);
        computeLength();
        solved.setNormal(dx / length, dy / length);
        if (hasMinimum) {
            exchangeByRule(bodies, a, b, restitution, rule, solved);
        } else {
            exchange(bodies, a, b, restitution, solved);
        }
    }

    /** Computes the vector from a to b; coinciding centres separate along x. */
    private void computeDirection(Bodies bodies, int a, int b) {
        double x = bodies.x[b] - bodies.x[a];
        double xRest = ErrorFree.sumError(bodies.x[b], -bodies.x[a], x) + (lows.x[b] - lows.x[a]);
        double y = bodies.y[b] - bodies.y[a];
        double yRest = ErrorFree.sumError(bodies.y[b], -bodies.y[a], y) + (lows.y[b] - lows.y[a]);
        dx = x + xRest;
        dxLow = ErrorFree.sumError(x, xRest, dx);
        dy = y + yRest;
        dyLow = ErrorFree.sumError(y, yRest, dy);
        scale = 0;
        double size = Math.max(Math.abs(dx), Math.abs(dy));
        coincident = size == 0;
        if (coincident) {
            dx = 1;
        } else if (!(size > 1 / LARGE && size < LARGE)) {
            scale = size < Double.MIN_NORMAL ? Math.getExponent(size * 0x1p54) - 54 : Math.getExponent(size);
            dx = Math.scalb(dx, -scale);
            dxLow = Math.scalb(dxLow, -scale);
            dy = Math.scalb(dy, -scale);
            dyLow = Math.scalb(dyLow, -scale);
        }
    }

    /** Computes |d| from d.d. */
    private void computeLength() {
        length = Math.sqrt(q.squared);
        double square = length * length;
        lengthLow = (((q.squared - square) - ErrorFree.productError(length, length, square)) + q.squaredLow)
            / (2 * length);
    }

    /**
     * Without a minimum impulse the velocities follow from q alone, or where nearly all of the relative velocity
     * changes, from what does not ({@link CentralImpact}); impulse and energy are only for the record.
     */
    private void exchange(Bodies bodies, int a, int b, double restitution, SolvedImpulse solved) {
        double massA = bodies.mass[a];
        double massB = bodies.mass[b];
        double speed = q.high * length;
        boolean isCentral = central.direction(dx, dxLow, dy, dyLow).squared(q.squared, q.squaredLow)
            .isCentral(bodies.vx[a], bodies.vx[b], bodies.vy[a], bodies.vy[b], q.high * q.squared);
        q.multiplyByOnePlus(restitution);
        double size = q.high;
        double sizeLow = q.low;
        q.multiplyByMassShare(massA, massB, size, sizeLow);
        double sizeOfB = q.high;
        double sizeLowOfB = q.low;
        q.multiplyByMassShare(massB, massA, size, sizeLow);
        if (isCentral) {
            central.apply(bodies, a, b, restitution);
        } else {
            ImpulseRegister.addVelocity(bodies, b, sizeOfB, sizeLowOfB, dx, dxLow, dy, dyLow);
            ImpulseRegister.addVelocity(bodies, a, -q.high, -q.low, dx, dxLow, dy, dyLow);
        }
        boolean light = massA <= massB;               // the heavier body's change can be too small for all its digits
        q.multiply(light ? q.high : sizeOfB, light ? q.low : sizeLowOfB, length, lengthLow);
        setImpulse(light ? massA : massB, speed, restitution, solved);
    }

    /** From the change of velocity of a mass, in the register. */
    private void setImpulse(double mass, double speed, double restitution, SolvedImpulse solved) {
        q.multiply(q.high, q.low, mass, 0);
        double impulse = q.high + q.low;
        solved.set(impulse, impulse * speed * (restitution - 1) / 2);
    }

    /** Computes the impulse under the law and applies it. */
    private void exchangeByRule(Bodies bodies, int a, int b, double restitution, Impulse rule, SolvedImpulse solved) {
        double massA = bodies.mass[a];
        double massB = bodies.mass[b];
        q.multiply(q.high, q.low, length, lengthLow);
        boolean finite = massA < Double.POSITIVE_INFINITY;
        q.multiplyByMassShare(finite ? massB : massA, finite ? massA : massB, q.high, q.low);
        if ((finite ? massA : massB) != 1) {          // most masses are 1
            q.multiply(q.high, q.low, finite ? massA : massB, 0);
        }
        sumSteps(rule, restitution, bodies.inverseMass[a] + bodies.inverseMass[b], solved);
        q.divide(work.high(), work.low(), length, lengthLow);
        double size = q.high;
        double sizeLow = q.low;
        applyImpulse(bodies, a, -size, -sizeLow);
        applyImpulse(bodies, b, size, sizeLow);
    }

    /** Computes the impulse from the first step and leaves it in {@code work}. */
    private void sumSteps(Impulse rule, double restitution, double inverse, SolvedImpulse solved) {
        first.setFastSum(q.high, q.low);
        rule.toSecondStep(second.set(first), restitution);
        solved.set(work.set(first).add(second).high(),
            inverse * other.set(second).subtract(first).high() * (second.high() + first.high()) / 2);
    }

    private void applyImpulse(Bodies bodies, int body, double size, double sizeLow) {
        double mass = bodies.mass[body];
        if (mass == 1) {
            ImpulseRegister.addVelocity(bodies, body, size, sizeLow, dx, dxLow, dy, dyLow);
        } else if (mass < Double.POSITIVE_INFINITY) {
            q.divide(size, sizeLow, mass, 0);
            ImpulseRegister.addVelocity(bodies, body, q.high, q.low, dx, dxLow, dy, dyLow);
        }
    }

    @Override
    boolean exchangeWithWall(Bodies bodies, int a, int w, Wall wall, double restitution, Impulse rule,
                             SolvedImpulse solved) {
        wallTimes.normal(w, work.setSum(bodies.x[a], lows.x[a]), other.setSum(bodies.y[a], lows.y[a]), normalX,
            normalY);
        double mass = bodies.mass[a];
        q.project(bodies.vx[a], 0, bodies.vy[a], 0, normalX.high(), normalX.low(), normalY.high(), normalY.low());
        solved.setNormal(normalX.high(), normalY.high());
        double speed = q.high;
        if (!(speed > 0)) {
            return false;
        }
        if (hasMinimumAtWalls) {
            q.multiply(q.high, q.low, mass, 0);
            sumSteps(rule, restitution, bodies.inverseMass[a], solved);
            q.divide(work.high(), work.low(), mass, 0);
        } else {
            q.multiplyByOnePlus(restitution);
        }
        ImpulseRegister.addVelocity(bodies, a, -q.high, -q.low, normalX.high(), normalX.low(), normalY.high(),
            normalY.low());
        if (!hasMinimumAtWalls) {
            setImpulse(mass, speed, restitution, solved);
        }
        return true;
    }

    @Override
    boolean areApproaching(Bodies bodies, int a, int b) {
        return pairs.areApproaching(bodies, a, b);
    }

    /** Works along the line between the stored positions, because there the pair must not approach. */
    @Override
    void separate(Bodies bodies, int a, int b, double nx, double ny, double speeds) {
        if (!areApproaching(bodies, a, b)) {
            return;
        }
        double x = bodies.x[b] - bodies.x[a];
        double y = bodies.y[b] - bodies.y[a];
        roundApart(bodies, a, -x, -y);
        roundApart(bodies, b, x, y);
        double size = Math.max(Math.abs(x), Math.abs(y));
        super.separate(bodies, a, b, x / size, y / size, speeds);
    }

    /**
     * Moves a velocity to the next double of each component in a direction: where the positions are as stored, that
     * outweighs the rounding of the velocities, so nothing else is left to do.
     */
    private static void roundApart(Bodies bodies, int body, double x, double y) {
        if (bodies.inverseMass[body] > 0) {
            bodies.vx[body] = next(bodies.vx[body], x);
            bodies.vy[body] = next(bodies.vy[body], y);
        }
    }

    private static double next(double v, double direction) {
        return Math.abs(v) < Double.MIN_NORMAL || direction == 0 ? v
            : direction > 0 ? Math.nextUp(v) : Math.nextDown(v);
    }

    @Override
    boolean isPressed(Bodies bodies, int a, int w, Wall wall) {
        return wallTimes.until(bodies, a, w) == 0 && wallTimes.exactTime(bodies, a, w, work) && work.high() == 0;
    }

    @Override
    double overlap(Bodies bodies, int a, int b, SolvedImpulse solved) {
        double touch = bodies.radius[a] + bodies.radius[b];
        double distance = coincident ? 0 : Math.scalb(length, scale);
        double distanceLow = coincident ? 0 : Math.scalb(lengthLow, scale);
        double overlap = (touch - distance)
            + (ErrorFree.sumError(bodies.radius[a], bodies.radius[b], touch) - distanceLow);
        if (overlap >= -TOUCH * touch) {
            q.divide(dx, dxLow, length, lengthLow);
            normalX.setFastSum(q.high, q.low);
            q.divide(dy, dyLow, length, lengthLow);
            normalY.setFastSum(q.high, q.low);
        }
        return Math.abs(overlap) <= TOUCH * touch ? 0 : overlap;
    }

    @Override
    void moveAlongNormal(Bodies bodies, int body, double by, SolvedImpulse solved) {
        double x = bodies.x[body];
        double y = bodies.y[body];
        bodies.x[body] = work.set(normalX).multiply(by).add(lows.x[body]).add(x).high();
        bodies.y[body] = work.set(normalY).multiply(by).add(lows.y[body]).add(y).high();
        lows.clear(body);
    }

    @Override
    boolean keepsRounding() {
        return true;
    }

    @Override
    void forgetRounding(int body) {
        lows.clear(body);
    }
}
