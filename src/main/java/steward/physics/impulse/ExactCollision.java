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
 * The reactions of {@link CarefulCollision} from where the bodies are before rounding (see {@link LowParts}): all
 * numbers are two doubles each, good to some units of 2^-106, and impulse and new
 * velocities are rounded once, when they are stored. Masses count as stored, not their rounded inverses. Two bodies
 * that touch but for 2^-60 of the distance touch: that is what a time of impact in double-double leaves open.
 *
 * <p>Under a law in which only approach reacts, rounding the positions can make two seem to approach that have just
 * been sent apart, when the impact grazes more closely (the cosine between normal and velocity) than the positions are
 * rounded, relative to the touching distance. Then, and after an impact without restitution, what is left of the
 * approach is taken away as in {@link Collision}; exact signs say whether there is any.
 */
public sealed class ExactCollision extends CarefulCollision permits ExactMinimumImpulse {

    private static final double TOUCH = 0x1p-60;
    private static final double WALL_TOUCH = 0x1p-46;
    /** Distances from here to its inverse need not be scaled: times any speed they are in the range of doubles. */
    private static final double LARGE = 0x1p20;

    private final ExactPairs pairs;
    private final ExactWalls wallTimes;
    private final LowParts lows;
    private final DoubleDouble normalX = new DoubleDouble();
    private final DoubleDouble normalY = new DoubleDouble();
    final DoubleDouble work = new DoubleDouble();
    final DoubleDouble other = new DoubleDouble();

    /** From centre to centre, times 2^-scale; and its length. */
    double dx;
    double dxLow;
    double dy;
    double dyLow;
    private int scale;
    private boolean coincident;
    double length;
    double lengthLow;
    /** Of the impact at hand. */
    double impulse;
    double energy;

    /** What the law needs, and no more. */
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
        direct(bodies, a, b);
        project(vax, vbx, vay, vby, dx, dxLow, dy, dyLow);
        measure();
        double restitution = restitutionRule.ofPair(bodies, a, b);
        exchange(bodies, a, b, restitution);
        separation.end(this, bodies, a, b, dx, dy, Math.abs(vax) + Math.abs(vay) + Math.abs(vbx) + Math.abs(vby));
        sink.impact(time, bodies.id(a), bodies.id(b), ax, ay, bx, by, dx / length, dy / length, impulse, energy,
            bodies.mass[a], bodies.mass[b], vax, vay, bodies.vx[a], bodies.vy[a], vbx, vby, bodies.vx[b],
            bodies.vy[b]);
        sink.knot(bodies.id(a), time, ax, ay);
        sink.knot(bodies.id(b), time, bx, by);
        correction.pair(this, bodies, a, b, dx, dy, length, time, sink);
    }

    /** The vector from a to b; centres that coincide part along x. */
    private void direct(Bodies bodies, int a, int b) {
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

    /** |d| from d.d. */
    private void measure() {
        length = Math.sqrt(squared);
        double square = length * length;
        lengthLow = (((squared - square) - ErrorFree.productError(length, length, square)) + squaredLow)
            / (2 * length);
    }

    /** Without a minimum impulse, speeds say all: the impulse is only for the record. */
    void exchange(Bodies bodies, int a, int b, double restitution) {
        double massA = bodies.mass[a];
        double massB = bodies.mass[b];
        double speed = high * length;
        withRestitution(restitution);
        double size = high;
        double sizeLow = low;
        takeShare(massA, massB, size, sizeLow);
        push(bodies, b, high, low, dx, dxLow, dy, dyLow);
        double sizeOfB = high;
        double sizeLowOfB = low;
        takeShare(massB, massA, size, sizeLow);
        push(bodies, a, -high, -low, dx, dxLow, dy, dyLow);
        boolean light = massA <= massB;               // the other's share can be too small for all its digits
        multiply(light ? high : sizeOfB, light ? low : sizeLowOfB, length, lengthLow);
        multiply(high, low, light ? massA : massB, 0);
        impulse = high + low;
        energy = impulse * speed * (restitution - 1) / 2;
    }

    @Override
    public void reactWall(Bodies bodies, int a, int w, double time, TurnSink sink) {
        Wall wall = walls[w];
        double ax = bodies.x[a];
        double ay = bodies.y[a];
        wallTimes.normal(w, work.setSum(ax, lows.x[a]), other.setSum(ay, lows.y[a]), normalX, normalY);
        double nx = normalX.high();
        double ny = normalY.high();
        double vax = bodies.vx[a];
        double vay = bodies.vy[a];
        double mass = bodies.mass[a];
        project(vax, 0, vay, 0, nx, normalX.low(), ny, normalY.low());
        if (!(high > 0)) {                            // an earlier impact of the same batch has turned it round
            endApproachToWall(bodies, a, w);
            return;
        }
        double restitution = restitutionRule.atWall(bodies, a, wall);
        exchangeWithWall(bodies, a, restitution);
        endApproachToWall(bodies, a, w);
        double gap = wall.gap(ax, ay, bodies.radius[a]);
        double reach = gap + bodies.radius[a];
        sink.impact(time, bodies.id(a), ~w, ax, ay, ax + nx * reach, ay + ny * reach, nx, ny, impulse, energy, mass,
            Double.POSITIVE_INFINITY, vax, vay, bodies.vx[a], bodies.vy[a], 0, 0, 0, 0);
        sink.knot(bodies.id(a), time, ax, ay);
        correction.fromWall(this, bodies, a, nx, ny, gap, time, sink);
    }

    /** The same off a wall, along the normal. */
    void exchangeWithWall(Bodies bodies, int a, double restitution) {
        double speed = high;
        withRestitution(restitution);
        pushAlongNormal(bodies, a);
        multiply(high, low, bodies.mass[a], 0);
        impulse = high + low;
        energy = impulse * speed * (restitution - 1) / 2;
    }

    final void pushAlongNormal(Bodies bodies, int a) {
        push(bodies, a, -high, -low, normalX.high(), normalX.low(), normalY.high(), normalY.low());
    }

    @Override
    void settleAtWall(Bodies bodies, int a, double nx, double ny, double gap) {
    }

    @Override
    void pushFromWall(Bodies bodies, int a, double nx, double ny, double gap, double time, TurnSink sink) {
        double rounding = WALL_TOUCH * (Math.abs(bodies.x[a]) + Math.abs(bodies.y[a]) + bodies.radius[a]);
        if (gap <= rounding) {
            pushApart(bodies, a, (gap < -rounding ? gap : 0) - 2 * pushOut, time, sink);
        }
    }

    /** Along the line between the stored places, for it is there that they must not approach. */
    @Override
    void endApproach(Bodies bodies, int a, int b, double nx, double ny, double speeds) {
        if (!pairs.approach(bodies, a, b)) {
            return;
        }
        double x = bodies.x[b] - bodies.x[a];
        double y = bodies.y[b] - bodies.y[a];
        double size = Math.max(Math.abs(x), Math.abs(y));
        boolean ofA = bodies.inverseMass[a] >= bodies.inverseMass[b];
        int body = ofA ? a : b;
        double step = ofA ? -Math.ulp(speeds) : Math.ulp(speeds);
        while (pairs.approach(bodies, a, b)) {
            bodies.vx[body] += x / size * step;
            bodies.vy[body] += y / size * step;
            step *= 2;
        }
    }

    private void endApproachToWall(Bodies bodies, int a, int w) {
        double speed = Math.abs(bodies.vx[a]) + Math.abs(bodies.vy[a]);
        double step = -Math.ulp(speed);
        while (wallTimes.until(bodies, a, w) == 0 && wallTimes.exact(bodies, a, w, work) && work.high() == 0) {
            bodies.vx[a] += normalX.high() * step;
            bodies.vy[a] += normalY.high() * step;
            step *= 2;
            if (-step > speed) {                      // a wall that leaves no way out: nothing but rest ends this
                bodies.vx[a] = 0;
                bodies.vy[a] = 0;
                return;
            }
        }
    }

    @Override
    void pushApart(Bodies bodies, int a, int b, double nx, double ny, double ofCentres, double time, TurnSink sink) {
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
            pushApart(bodies, a, bodies.inverseMass[b] == 0 ? -2 * each : -each, time, sink);
            pushApart(bodies, b, bodies.inverseMass[a] == 0 ? 2 * each : each, time, sink);
        }
    }

    private void pushApart(Bodies bodies, int body, double by, double time, TurnSink sink) {
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
