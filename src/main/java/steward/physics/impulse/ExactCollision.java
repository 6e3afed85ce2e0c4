package steward.physics.impulse;

import steward.numerics.DoubleDouble;
import steward.numerics.ErrorFree;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;
import steward.physics.TurnSink;
import steward.physics.Wall;
import steward.physics.time.ExactPairs;
import steward.physics.time.ExactWalls;
import steward.physics.time.LowParts;

/**
 * The reactions of {@link CompensatedCollision}, computed from the positions before rounding (see {@link LowParts}):
 * all numbers are two doubles each, accurate to some units of 2^-106, and impulse and new velocities are rounded once,
 * when they are stored. The stored masses are used, not their rounded inverses. A gap of up to 2^-60 of the distance
 * counts as contact: a time of impact in double-double is not more accurate.
 *
 * <p>Under a law in which only approach reacts, the rounding of positions can make a pair approach again right after
 * its impact. This happens when the cosine between normal and velocity is below the rounding of the positions relative
 * to the touching distance; where the positions are as stored, the rounding of the velocities can do so. Then, and
 * after an impact without restitution, the residual approach is removed: first by a unit in the last place of each
 * velocity, and where that is not enough, as in {@link Collision}; exact signs decide whether there is any.
 */
public sealed class ExactCollision extends CompensatedCollision permits ExactMinimumImpulse {

    private static final double TOUCH = 0x1p-60;
    private static final double WALL_TOUCH = 0x1p-46;
    /**
     * Distances between the inverse of this and this need no scaling: times any speed they are in the range of doubles.
     */
    private static final double LARGE = 0x1p20;

    private final ExactPairs pairs;
    private final ExactWalls wallTimes;
    private final LowParts lows;
    private final CentralImpact central = new CentralImpact();
    private boolean former;
    private final DoubleDouble normalX = new DoubleDouble();
    private final DoubleDouble normalY = new DoubleDouble();
    final DoubleDouble work = new DoubleDouble();
    final DoubleDouble other = new DoubleDouble();

    /** The vector from centre to centre, times 2^-scale, and its length. */
    double dx;
    double dxLow;
    double dy;
    double dyLow;
    private int scale;
    private boolean coincident;
    double length;
    double lengthLow;
    /** Of the current impact. */
    double impulse;
    double energy;

    /** The simplest instance that computes the law. */
    public static ExactCollision of(ImpactLaw law, Wall[] walls, ExactPairs pairs, ExactWalls wallTimes,
                                    LowParts lows) {
        return !(law.minimumImpulse() > 0) ? new ExactCollision(law, walls, pairs, wallTimes, lows)
            : law.minimumImpulseAtWalls() ? new ExactMinimumImpulse.WallsIncluded(law, walls, pairs, wallTimes, lows)
            : new ExactMinimumImpulse(law, walls, pairs, wallTimes, lows);
    }

    ExactCollision(ImpactLaw law, Wall[] walls, ExactPairs pairs, ExactWalls wallTimes, LowParts lows) {
        super(law, walls);
        this.pairs = pairs;
        this.wallTimes = wallTimes;
        this.lows = lows;
    }

    /** Reacts so, without {@link CentralImpact}, and removes a residual approach along the normal only. */
    @Override
    public Collision ofFormerReplays() {
        former = true;
        return super.ofFormerReplays();
    }

    @Override
    public void reactPair(Bodies bodies, int a, int b, double time, TurnSink sink) {
        double ax = bodies.x[a];
        double ay = bodies.y[a];
        double bx = bodies.x[b];
        double by = bodies.y[b];
        double vax = bodies.vx[a];
        double vay = bodies.vy[a];
        double vbx = bodies.vx[b];
        double vby = bodies.vy[b];
        computeDirection(bodies, a, b);
        project(vax, vbx, vay, vby, dx, dxLow, dy, dyLow);
        computeLength();
        double restitution = restitutionRule.betweenBodies(bodies, a, b);
        exchangeImpulse(bodies, a, b, restitution);
        separation.enforce(this, bodies, a, b, dx, dy, Math.abs(vax) + Math.abs(vay) + Math.abs(vbx) + Math.abs(vby));
        sink.impact(time, bodies.id(a), bodies.id(b), ax, ay, bx, by, dx / length, dy / length, impulse, energy,
            bodies.mass[a], bodies.mass[b], vax, vay, bodies.vx[a], bodies.vy[a], vbx, vby, bodies.vx[b],
            bodies.vy[b]);
        sink.knot(bodies.id(a), time, ax, ay);
        sink.knot(bodies.id(b), time, bx, by);
        correction.correctPair(this, bodies, a, b, dx, dy, length, time, sink);
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
        length = Math.sqrt(squared);
        double square = length * length;
        lengthLow = (((squared - square) - ErrorFree.productError(length, length, square)) + squaredLow)
            / (2 * length);
    }

    /**
     * Applies the impulse. Without a minimum impulse the velocities follow from q alone, or where nearly all of the
     * relative velocity changes, from what does not ({@link CentralImpact}); impulse and energy are only for the
     * record.
     */
    void exchangeImpulse(Bodies bodies, int a, int b, double restitution) {
        double massA = bodies.mass[a];
        double massB = bodies.mass[b];
        double speed = high * length;
        boolean isCentral = !former && central.direction(dx, dxLow, dy, dyLow).squared(squared, squaredLow)
            .isCentral(bodies.vx[a], bodies.vx[b], bodies.vy[a], bodies.vy[b], high * squared);
        multiplyByOnePlus(restitution);
        double size = high;
        double sizeLow = low;
        multiplyByMassShare(massA, massB, size, sizeLow);
        double sizeOfB = high;
        double sizeLowOfB = low;
        multiplyByMassShare(massB, massA, size, sizeLow);
        if (isCentral) {
            central.apply(bodies, a, b, restitution);
        } else {
            addVelocity(bodies, b, sizeOfB, sizeLowOfB, dx, dxLow, dy, dyLow);
            addVelocity(bodies, a, -high, -low, dx, dxLow, dy, dyLow);
        }
        boolean light = massA <= massB;               // the heavier body's change can be too small for all its digits
        multiply(light ? high : sizeOfB, light ? low : sizeLowOfB, length, lengthLow);
        multiply(high, low, light ? massA : massB, 0);
        impulse = high + low;
        energy = impulse * speed * (restitution - 1) / 2;
    }

    @Override
    public void reactWall(Bodies bodies, int a, int w, double time, TurnSink sink) {
        Wall wall = walls[w];
        if (slides && RimSliding.slide(bodies, a, w, wall, time, sink)) {
            lows.clear(a);
            return;
        }
        double ax = bodies.x[a];
        double ay = bodies.y[a];
        wallTimes.normal(w, work.setSum(ax, lows.x[a]), other.setSum(ay, lows.y[a]), normalX, normalY);
        double nx = normalX.high();
        double ny = normalY.high();
        double vax = bodies.vx[a];
        double vay = bodies.vy[a];
        double mass = bodies.mass[a];
        project(vax, 0, vay, 0, nx, normalX.low(), ny, normalY.low());
        if (!(high > 0)) {                            // an earlier impact of the same batch has reversed it
            removeResidualApproachToWall(bodies, a, w);
            return;
        }
        double restitution = restitutionRule.atWall(bodies, a, wall);
        exchangeImpulseWithWall(bodies, a, restitution);
        removeResidualApproachToWall(bodies, a, w);
        double gap = wall.gap(ax, ay, bodies.radius[a]);
        double reach = gap + bodies.radius[a];
        sink.impact(time, bodies.id(a), ~w, ax, ay, ax + nx * reach, ay + ny * reach, nx, ny, impulse, energy, mass,
            Double.POSITIVE_INFINITY, vax, vay, bodies.vx[a], bodies.vy[a], 0, 0, 0, 0);
        sink.knot(bodies.id(a), time, ax, ay);
        correction.correctFromWall(this, bodies, a, nx, ny, gap, time, sink);
    }

    /** The same at a wall, along the normal. */
    void exchangeImpulseWithWall(Bodies bodies, int a, double restitution) {
        double speed = high;
        multiplyByOnePlus(restitution);
        applyAlongNormal(bodies, a);
        multiply(high, low, bodies.mass[a], 0);
        impulse = high + low;
        energy = impulse * speed * (restitution - 1) / 2;
    }

    final void applyAlongNormal(Bodies bodies, int a) {
        addVelocity(bodies, a, -high, -low, normalX.high(), normalX.low(), normalY.high(), normalY.low());
    }

    @Override
    void cancelRoundingPenetration(Bodies bodies, int a, double nx, double ny, double gap) {
    }

    @Override
    void correctFromWall(Bodies bodies, int a, double nx, double ny, double gap, double time, TurnSink sink) {
        double rounding = WALL_TOUCH * (Math.abs(bodies.x[a]) + Math.abs(bodies.y[a]) + bodies.radius[a]);
        if (gap <= rounding) {
            moveAlongNormal(bodies, a, (gap < -rounding ? gap : 0) - 2 * pushOut, time, sink);
        }
    }

    /** Works along the line between the stored positions, because there the pair must not approach. */
    @Override
    void removeResidualApproach(Bodies bodies, int a, int b, double nx, double ny, double speeds) {
        if (!pairs.areApproaching(bodies, a, b)) {
            return;
        }
        double x = bodies.x[b] - bodies.x[a];
        double y = bodies.y[b] - bodies.y[a];
        if (!former) {
            roundApart(bodies, a, -x, -y);
            roundApart(bodies, b, x, y);
        }
        double size = Math.max(Math.abs(x), Math.abs(y));
        boolean ofA = bodies.inverseMass[a] >= bodies.inverseMass[b];
        int body = ofA ? a : b;
        double step = ofA ? -Math.ulp(speeds) : Math.ulp(speeds);
        while (pairs.areApproaching(bodies, a, b)) {
            bodies.vx[body] += x / size * step;
            bodies.vy[body] += y / size * step;
            step *= 2;
        }
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

    private void removeResidualApproachToWall(Bodies bodies, int a, int w) {
        double speed = Math.abs(bodies.vx[a]) + Math.abs(bodies.vy[a]);
        double step = -Math.ulp(speed);
        while (wallTimes.until(bodies, a, w) == 0 && wallTimes.exactTime(bodies, a, w, work) && work.high() == 0) {
            bodies.vx[a] += normalX.high() * step;
            bodies.vy[a] += normalY.high() * step;
            step *= 2;
            if (-step > speed) {                      // no velocity separates it from this wall but rest
                bodies.vx[a] = 0;
                bodies.vy[a] = 0;
                return;
            }
        }
    }

    @Override
    void correctPair(Bodies bodies, int a, int b, double nx, double ny, double ofCentres, double time, TurnSink sink) {
        double touch = bodies.radius[a] + bodies.radius[b];
        double distance = coincident ? 0 : Math.scalb(length, scale);
        double distanceLow = coincident ? 0 : Math.scalb(lengthLow, scale);
        double overlap = (touch - distance)
            + (ErrorFree.sumError(bodies.radius[a], bodies.radius[b], touch) - distanceLow);
        if (overlap >= -TOUCH * touch) {
            double each = (overlap <= TOUCH * touch ? 0 : overlap / 2) + pushOut;
            divide(dx, dxLow, length, lengthLow);
            normalX.setFastSum(high, low);
            divide(dy, dyLow, length, lengthLow);
            normalY.setFastSum(high, low);
            moveAlongNormal(bodies, a, bodies.inverseMass[b] == 0 ? -2 * each : -each, time, sink);
            moveAlongNormal(bodies, b, bodies.inverseMass[a] == 0 ? 2 * each : each, time, sink);
        }
    }

    private void moveAlongNormal(Bodies bodies, int body, double by, double time, TurnSink sink) {
        if (bodies.inverseMass[body] > 0) {
            double x = bodies.x[body];
            double y = bodies.y[body];
            bodies.x[body] = work.set(normalX).multiply(by).add(lows.x[body]).add(x).high();
            bodies.y[body] = work.set(normalY).multiply(by).add(lows.y[body]).add(y).high();
            lows.clear(body);
            sink.knot(bodies.id(body), time, bodies.x[body], bodies.y[body]);
        }
    }
}
