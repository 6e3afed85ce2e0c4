package steward.physics;

import steward.numerics.DoubleDouble;

/**
 * The reactions of {@link Collision} in double-double: normal, impulse and new velocities are computed from where the
 * bodies are before rounding (see {@link ExactFlight}) and rounded once each, when stored. Masses count as stored, not
 * their rounded inverses. Two bodies that touch but for 2^-60 of the distance touch: that is what a time of impact in
 * double-double leaves open.
 *
 * <p>Under a law in which only approach reacts, rounding the positions can make two seem to approach that have just
 * been sent apart, when the impact grazes more closely (the cosine between normal and velocity) than the positions are
 * rounded, relative to the touching distance. Then, and after an impact without restitution, what is left of the
 * approach is taken away as in {@link Collision}; exact signs say whether there is any.
 */
final class ExactCollision extends Collision {

    private static final double TOUCH = 0x1p-60;
    private static final double WALL_TOUCH = 0x1p-46;

    private final ExactPairs pairs;
    private final ExactWalls wallTimes;
    private final ExactFlight flight;
    private final DoubleDouble normalX = new DoubleDouble();
    private final DoubleDouble normalY = new DoubleDouble();
    private final DoubleDouble distance = new DoubleDouble();
    private final DoubleDouble inverseA = new DoubleDouble();
    private final DoubleDouble inverseB = new DoubleDouble();
    private final DoubleDouble inverse = new DoubleDouble();
    private final DoubleDouble first = new DoubleDouble();
    private final DoubleDouble second = new DoubleDouble();
    private final DoubleDouble impulse = new DoubleDouble();
    private final DoubleDouble work = new DoubleDouble();
    private final DoubleDouble other = new DoubleDouble();

    ExactCollision(ImpactLaw law, Wall[] walls, ExactPairs pairs, ExactWalls wallTimes, ExactFlight flight) {
        super(law, walls);
        this.pairs = pairs;
        this.wallTimes = wallTimes;
        this.flight = flight;
    }

    @Override
    void reactPair(Bodies bodies, int a, int b, double time, TurnSink sink) {
        double ax = bodies.x[a];
        double ay = bodies.y[a];
        double bx = bodies.x[b];
        double by = bodies.y[b];
        normalX.setDifference(bx, ax).add(work.setDifference(flight.lowX(b), flight.lowX(a)));
        normalY.setDifference(by, ay).add(work.setDifference(flight.lowY(b), flight.lowY(a)));
        ExactWall.normalize(normalX, normalY, distance, work);
        double vax = bodies.vx[a];
        double vay = bodies.vy[a];
        double vbx = bodies.vx[b];
        double vby = bodies.vy[b];
        invert(bodies.mass[a], inverseA);
        invert(bodies.mass[b], inverseB);
        inverse.set(inverseA).add(inverseB);
        first.setDifference(vax, vbx).multiply(normalX)
            .add(work.setDifference(vay, vby).multiply(normalY));
        divideByInverse();
        takeSecondStep(pairImpulse, elastic ? ELASTIC : Math.min(bodies.restitution[a], bodies.restitution[b]));
        push(bodies, a, inverseA, -1);
        push(bodies, b, inverseB, 1);
        if (partsForGood) {
            endApproach(bodies, a, b, Math.abs(vax) + Math.abs(vay) + Math.abs(vbx) + Math.abs(vby));
        }
        double nx = normalX.high();
        double ny = normalY.high();
        double massA = bodies.mass[a];
        double massB = bodies.mass[b];
        sink.impact(time, bodies.id(a), bodies.id(b), ax, ay, bx, by, nx, ny, impulse.high(), energy(), massA, massB,
            vax, vay, bodies.vx[a], bodies.vy[a], vbx, vby, bodies.vx[b], bodies.vy[b]);
        sink.knot(bodies.id(a), time, ax, ay);
        sink.knot(bodies.id(b), time, bx, by);
        if (pushes) {
            pushApart(bodies, a, b, time, sink);
        }
    }

    @Override
    void reactWall(Bodies bodies, int a, int w, double time, TurnSink sink) {
        Wall wall = walls[w];
        double ax = bodies.x[a];
        double ay = bodies.y[a];
        wallTimes.normal(w, work.setSum(ax, flight.lowX(a)), other.setSum(ay, flight.lowY(a)), normalX, normalY);
        double vax = bodies.vx[a];
        double vay = bodies.vy[a];
        invert(bodies.mass[a], inverse);
        first.set(normalX).multiply(vax).add(work.set(normalY).multiply(vay));
        if (!(first.high() > 0)) {                    // an earlier impact of the same batch has turned it round
            endApproachToWall(bodies, a, w);
            return;
        }
        divideByInverse();
        takeSecondStep(wallImpulse, elastic ? ELASTIC : Math.min(bodies.restitution[a], wall.restitution()));
        push(bodies, a, inverse, -1);
        endApproachToWall(bodies, a, w);
        double nx = normalX.high();
        double ny = normalY.high();
        double gap = wall.gap(ax, ay, bodies.radius[a]);
        double reach = gap + bodies.radius[a];
        sink.impact(time, bodies.id(a), ~w, ax, ay, ax + nx * reach, ay + ny * reach, nx, ny, impulse.high(), energy(),
            bodies.mass[a], Double.POSITIVE_INFINITY, vax, vay, bodies.vx[a], bodies.vy[a], 0, 0, 0, 0);
        sink.knot(bodies.id(a), time, ax, ay);
        double rounding = WALL_TOUCH * (Math.abs(ax) + Math.abs(ay) + bodies.radius[a]);
        if (pushes && gap <= rounding) {
            pushApart(bodies, a, (gap < -rounding ? gap : 0) - 2 * pushOut, time, sink);
        }
    }

    private void invert(double mass, DoubleDouble result) {
        result.set(mass == Double.POSITIVE_INFINITY ? 0 : 1);
        if (mass != 1 && mass < Double.POSITIVE_INFINITY) {
            result.divide(work.set(mass));
        }
    }

    /** The first step of the impulse from the approach speed; a power of two divides exactly. */
    private void divideByInverse() {
        boolean powerOfTwo = inverse.low() == 0 && (Double.doubleToRawLongBits(inverse.high()) << 12) == 0;
        if (powerOfTwo) {
            first.multiply(1 / inverse.high());
        } else {
            first.divide(inverse);
        }
    }

    private void takeSecondStep(Impulse law, double restitution) {
        law.toSecondStep(second.set(first), restitution);
        impulse.set(first).add(second);
    }

    /** Velocities change by the impulse over the mass along the normal. */
    private void push(Bodies bodies, int body, DoubleDouble inverseMass, int sign) {
        if (inverseMass.high() > 0) {
            work.set(impulse);
            if (inverseMass.high() != 1 || inverseMass.low() != 0) {
                work.multiply(inverseMass);
            }
            if (sign < 0) {
                work.negate();
            }
            bodies.vx[body] = other.set(work).multiply(normalX).add(bodies.vx[body]).high();
            bodies.vy[body] = other.set(work).multiply(normalY).add(bodies.vy[body]).high();
        }
    }

    private double energy() {
        return inverse.high() * work.set(second).subtract(first).high() * (second.high() + first.high()) / 2;
    }

    /** Along the line between the stored places, for it is there that they must not approach. */
    private void endApproach(Bodies bodies, int a, int b, double speeds) {
        if (!pairs.approach(bodies, a, b)) {
            return;
        }
        double dx = bodies.x[b] - bodies.x[a];
        double dy = bodies.y[b] - bodies.y[a];
        double size = Math.max(Math.abs(dx), Math.abs(dy));
        boolean ofA = bodies.inverseMass[a] >= bodies.inverseMass[b];
        int body = ofA ? a : b;
        double step = ofA ? -Math.ulp(speeds) : Math.ulp(speeds);
        while (pairs.approach(bodies, a, b)) {
            bodies.vx[body] += dx / size * step;
            bodies.vy[body] += dy / size * step;
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

    private void pushApart(Bodies bodies, int a, int b, double time, TurnSink sink) {
        double touch = bodies.radius[a] + bodies.radius[b];
        double overlap = other.setSum(bodies.radius[a], bodies.radius[b]).subtract(distance).high();
        if (overlap >= -TOUCH * touch) {
            double each = (overlap <= TOUCH * touch ? 0 : overlap / 2) + pushOut;
            pushApart(bodies, a, bodies.inverseMass[b] == 0 ? -2 * each : -each, time, sink);
            pushApart(bodies, b, bodies.inverseMass[a] == 0 ? 2 * each : each, time, sink);
        }
    }

    private void pushApart(Bodies bodies, int body, double by, double time, TurnSink sink) {
        if (bodies.inverseMass[body] > 0) {
            double x = bodies.x[body];
            double y = bodies.y[body];
            bodies.x[body] = work.set(normalX).multiply(by).add(flight.lowX(body)).add(x).high();
            bodies.y[body] = work.set(normalY).multiply(by).add(flight.lowY(body)).add(y).high();
            flight.moved(body);
            sink.knot(bodies.id(body), time, bodies.x[body], bodies.y[body]);
        }
    }
}
