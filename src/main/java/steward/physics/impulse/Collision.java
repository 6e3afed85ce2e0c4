package steward.physics.impulse;

import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;
import steward.physics.TurnSink;
import steward.physics.Wall;
import steward.physics.time.TimeOfImpact;

/**
 * Lets a pair, or a body and a wall, react under a law: impulse, push-out, record. As it is, with the expressions of
 * the published official referee in their order.
 */
public sealed class Collision permits CarefulCollision, OfficialCollision {

    /** A body so far behind a wall, relative to its coordinates, is there by rounding: some units in the last place. */
    private static final double ROUNDING = 0x1p-46;

    final Impulse pairImpulse;
    final Impulse wallImpulse;
    final CollisionParts.RestitutionRule restitutionRule;
    final CollisionParts.Separation separation;
    final CollisionParts.PositionalCorrection correction;
    final double pushOut;
    final Wall[] walls;

    public Collision(ImpactLaw law, Wall[] walls) {
        pairImpulse = Impulse.of(law, true);
        wallImpulse = Impulse.of(law, law.minimumImpulseAtWalls());
        CollisionParts parts = CollisionParts.of(law);
        restitutionRule = parts.restitutionRule();
        separation = parts.separation();
        correction = parts.correction();
        pushOut = law.pushOut();
        this.walls = walls;
    }

    /** The reactions of an arithmetic other than {@code EXACT}, which needs to know more. */
    public static Collision of(ImpactLaw law, Arithmetic arithmetic, Wall[] walls) {
        if (arithmetic == Arithmetic.OFFICIAL) {
            return new OfficialCollision(law, walls);
        }
        return law.minimumImpulse() > 0 ? new Collision(law, walls) : new CarefulCollision(law, walls);
    }

    /** @param b an index, or {@code ~wall} */
    public void react(Bodies bodies, int a, int b, double time, TurnSink sink) {
        if (b < 0) {
            reactWall(bodies, a, ~b, time, sink);
        } else {
            reactPair(bodies, a, b, time, sink);
        }
    }

    /** Centres that coincide have no direction: they part along x. */
    public void reactPair(Bodies bodies, int a, int b, double time, TurnSink sink) {
        double ax = bodies.x[a];
        double ay = bodies.y[a];
        double bx = bodies.x[b];
        double by = bodies.y[b];
        double dx = bx - ax;
        double dy = by - ay;
        double distance = Math.sqrt(dx * dx + dy * dy);
        double nx = distance == 0 ? 1 : dx / distance;
        double ny = distance == 0 ? 0 : dy / distance;
        double vax = bodies.vx[a];
        double vay = bodies.vy[a];
        double vbx = bodies.vx[b];
        double vby = bodies.vy[b];
        double inverse = bodies.inverseMass[a] + bodies.inverseMass[b];
        double first = (nx * (vax - vbx) + ny * (vay - vby)) / inverse;
        double restitution = restitutionRule.ofPair(bodies, a, b);
        double second = pairImpulse.secondStep(first, restitution);
        double impulse = first + second;
        double massA = bodies.mass[a];
        double massB = bodies.mass[b];
        pushPair(bodies, a, b, nx, ny, restitution, impulse);
        separation.end(this, bodies, a, b, nx, ny, Math.abs(vax) + Math.abs(vay) + Math.abs(vbx) + Math.abs(vby));
        sink.impact(time, bodies.id(a), bodies.id(b), ax, ay, bx, by, nx, ny, impulse,
            inverse * (second * second - first * first) / 2, massA, massB,
            vax, vay, bodies.vx[a], bodies.vy[a], vbx, vby, bodies.vx[b], bodies.vy[b]);
        sink.knot(bodies.id(a), time, ax, ay);
        sink.knot(bodies.id(b), time, bx, by);
        correction.pair(this, bodies, a, b, nx, ny, distance, time, sink);
    }

    /** An impulse along the unit vector from a to b sends the two apart. */
    void pushPair(Bodies bodies, int a, int b, double nx, double ny, double restitution, double impulse) {
        double massA = bodies.mass[a];
        double massB = bodies.mass[b];
        bodies.vx[a] -= nx * impulse / massA;
        bodies.vy[a] -= ny * impulse / massA;
        bodies.vx[b] += nx * impulse / massB;
        bodies.vy[b] += ny * impulse / massB;
    }

    /** An impulse against the unit vector to a wall sends a body back. */
    void pushOffWall(Bodies bodies, int a, double nx, double ny, double restitution, double impulse) {
        double mass = bodies.mass[a];
        bodies.vx[a] -= nx * impulse / mass;
        bodies.vy[a] -= ny * impulse / mass;
    }

    public void reactWall(Bodies bodies, int a, int w, double time, TurnSink sink) {
        Wall wall = walls[w];
        double ax = bodies.x[a];
        double ay = bodies.y[a];
        double nx = wall.normalX(ax, ay);
        double ny = wall.normalY(ax, ay);
        double vax = bodies.vx[a];
        double vay = bodies.vy[a];
        double mass = bodies.mass[a];
        double inverse = bodies.inverseMass[a];
        double approach = nx * vax + ny * vay;
        if (!(approach > 0)) {                        // an earlier impact of the same batch has turned it round
            endApproachToWall(bodies, a, wall, nx, ny);
            return;
        }
        double first = approach / inverse;
        double restitution = restitutionRule.atWall(bodies, a, wall);
        double second = wallImpulse.secondStep(first, restitution);
        double impulse = first + second;
        pushOffWall(bodies, a, nx, ny, restitution, impulse);
        endApproachToWall(bodies, a, wall, nx, ny);
        double gap = wall.gap(ax, ay, bodies.radius[a]);
        double reach = gap + bodies.radius[a];
        sink.impact(time, bodies.id(a), ~w, ax, ay, ax + nx * reach, ay + ny * reach, nx, ny, impulse,
            inverse * (second * second - first * first) / 2, mass, Double.POSITIVE_INFINITY,
            vax, vay, bodies.vx[a], bodies.vy[a], 0, 0, 0, 0);
        sink.knot(bodies.id(a), time, ax, ay);
        correction.fromWall(this, bodies, a, nx, ny, gap, time, sink);
    }

    /** Ten thousand impacts, all rounded outward, would add up. */
    void settleAtWall(Bodies bodies, int a, double nx, double ny, double gap) {
        if (gap < 0 && -gap < ROUNDING * (Math.abs(bodies.x[a]) + Math.abs(bodies.y[a]) + bodies.radius[a])) {
            bodies.x[a] += nx * gap;
            bodies.y[a] += ny * gap;
        }
    }

    /** From behind a wall, or from its face: to where it is touched, and twice as far as one of a pair beyond. */
    void pushFromWall(Bodies bodies, int a, double nx, double ny, double gap, double time, TurnSink sink) {
        if (gap <= 0) {
            pushApart(bodies, a, nx, ny, gap - 2 * pushOut, time, sink);
        }
    }

    /** Each by half of the overlap and a little more; one alone by all of it if the other cannot be moved. */
    void pushApart(Bodies bodies, int a, int b, double nx, double ny, double distance, double time, TurnSink sink) {
        double overlap = bodies.radius[a] + bodies.radius[b] - distance;
        if (overlap >= 0) {
            double each = overlap / 2 + pushOut;
            pushApart(bodies, a, nx, ny, bodies.mass[b] == Double.POSITIVE_INFINITY ? -2 * each : -each, time, sink);
            pushApart(bodies, b, nx, ny, bodies.mass[a] == Double.POSITIVE_INFINITY ? 2 * each : each, time, sink);
        }
    }

    /*
     * Rounding can leave a trace of approach behind an impulse that should have ended it (no restitution, or hardly
     * any). Where only approach reacts, the two would react again at the same instant, and again, each impulse too
     * small to change a digit of a speed, until the bound on impacts. So what is left is taken away in steps that
     * double, from one unit in the last place of the speeds: an error as large as that of storing them.
     */

    /** @param speeds of both before, summed: say what a unit in the last place is */
    void endApproach(Bodies bodies, int a, int b, double nx, double ny, double speeds) {
        double dx = bodies.x[b] - bodies.x[a];
        double dy = bodies.y[b] - bodies.y[a];
        boolean first = bodies.inverseMass[a] >= bodies.inverseMass[b];
        int body = first ? a : b;
        double step = first ? -Math.ulp(speeds) : Math.ulp(speeds);
        while (dx * (bodies.vx[b] - bodies.vx[a]) + dy * (bodies.vy[b] - bodies.vy[a]) < 0) {
            bodies.vx[body] += nx * step;
            bodies.vy[body] += ny * step;
            step *= 2;
        }
    }

    private static void endApproachToWall(Bodies bodies, int a, Wall wall, double nx, double ny) {
        double speed = Math.abs(bodies.vx[a]) + Math.abs(bodies.vy[a]);
        double step = -Math.ulp(speed);
        while (TimeOfImpact.wall(wall, bodies.x[a], bodies.y[a], bodies.vx[a], bodies.vy[a], bodies.radius[a]) == 0) {
            bodies.vx[a] += nx * step;
            bodies.vy[a] += ny * step;
            step *= 2;
            if (-step > speed) {                      // a wall that leaves no way out: nothing but rest ends this
                bodies.vx[a] = 0;
                bodies.vy[a] = 0;
                return;
            }
        }
    }

    private static void pushApart(Bodies bodies, int body, double nx, double ny, double by, double time,
                                  TurnSink sink) {
        if (bodies.inverseMass[body] > 0) {
            bodies.x[body] += nx * by;
            bodies.y[body] += ny * by;
            sink.knot(bodies.id(body), time, bodies.x[body], bodies.y[body]);
        }
    }
}
