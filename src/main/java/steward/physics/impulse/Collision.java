package steward.physics.impulse;

import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;
import steward.physics.TurnSink;
import steward.physics.Wall;
import steward.physics.time.TimeOfImpact;

/**
 * The reaction of a pair, or of a body and a wall, under a law: impulse, positional correction, record. This class
 * itself uses the expressions of the published official referee in their order.
 */
public sealed class Collision permits CompensatedCollision, OfficialCollision {

    /**
     * A wall penetration below this, relative to the coordinates, is a rounding error: some units in the last place.
     */
    private static final double ROUNDING = 0x1p-46;

    final Impulse pairImpulse;
    final Impulse wallImpulse;
    final CollisionParts.RestitutionRule restitutionRule;
    final CollisionParts.Separation separation;
    final CollisionParts.PositionalCorrection correction;
    final double pushOut;
    final Wall[] walls;
    /** Whether bodies can slide along an arena. */
    boolean slides;

    public Collision(ImpactLaw law, Wall[] walls) {
        pairImpulse = Impulse.of(law, true);
        wallImpulse = Impulse.of(law, law.minimumImpulseAtWalls());
        CollisionParts parts = CollisionParts.of(law);
        restitutionRule = parts.restitutionRule();
        separation = parts.separation();
        correction = parts.correction();
        pushOut = law.pushOut();
        this.walls = walls;
        slides = RimSliding.isPossible(law, walls);
    }

    /** The reactions of an arithmetic other than {@code EXACT}, for which see {@link ExactCollision#of}. */
    public static Collision of(ImpactLaw law, Arithmetic arithmetic, Wall[] walls) {
        if (arithmetic == Arithmetic.OFFICIAL) {
            return new OfficialCollision(law, walls);
        }
        if (arithmetic == Arithmetic.FORMER_OFFICIAL || law.minimumImpulse() > 0) {
            return new Collision(law, walls);
        }
        return arithmetic == Arithmetic.COMPENSATED
            ? new CompensatedCollision.Judging(law, walls) : new CompensatedCollision(law, walls);
    }

    /** Reacts as in replays of formats 1 and 2: every contact with an arena is a bounce. */
    public Collision ofFormerReplays() {
        slides = false;
        return this;
    }

    /** @param b an index, or {@code ~wall} */
    public void react(Bodies bodies, int a, int b, double time, TurnSink sink) {
        if (b < 0) {
            reactWall(bodies, a, ~b, time, sink);
        } else {
            reactPair(bodies, a, b, time, sink);
        }
    }

    /** Coinciding centres have no direction: they separate along x. */
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
        double restitution = restitutionRule.betweenBodies(bodies, a, b);
        double second = pairImpulse.secondStep(first, restitution);
        double impulse = first + second;
        double massA = bodies.mass[a];
        double massB = bodies.mass[b];
        applyPairImpulse(bodies, a, b, nx, ny, restitution, impulse);
        separation.enforce(this, bodies, a, b, nx, ny, Math.abs(vax) + Math.abs(vay) + Math.abs(vbx) + Math.abs(vby));
        sink.impact(time, bodies.id(a), bodies.id(b), ax, ay, bx, by, nx, ny, impulse,
            inverse * (second * second - first * first) / 2, massA, massB,
            vax, vay, bodies.vx[a], bodies.vy[a], vbx, vby, bodies.vx[b], bodies.vy[b]);
        sink.knot(bodies.id(a), time, ax, ay);
        sink.knot(bodies.id(b), time, bx, by);
        correction.correctPair(this, bodies, a, b, nx, ny, distance, time, sink);
    }

    /** Applies an impulse along the unit vector from a to b. */
    void applyPairImpulse(Bodies bodies, int a, int b, double nx, double ny, double restitution, double impulse) {
        double massA = bodies.mass[a];
        double massB = bodies.mass[b];
        bodies.vx[a] -= nx * impulse / massA;
        bodies.vy[a] -= ny * impulse / massA;
        bodies.vx[b] += nx * impulse / massB;
        bodies.vy[b] += ny * impulse / massB;
    }

    /** Applies an impulse against the unit vector to a wall. */
    void applyWallImpulse(Bodies bodies, int a, double nx, double ny, double restitution, double impulse) {
        double mass = bodies.mass[a];
        bodies.vx[a] -= nx * impulse / mass;
        bodies.vy[a] -= ny * impulse / mass;
    }

    public void reactWall(Bodies bodies, int a, int w, double time, TurnSink sink) {
        Wall wall = walls[w];
        if (slides && RimSliding.slide(bodies, a, w, wall, time, sink)) {
            return;
        }
        double ax = bodies.x[a];
        double ay = bodies.y[a];
        double nx = wall.normalX(ax, ay);
        double ny = wall.normalY(ax, ay);
        double vax = bodies.vx[a];
        double vay = bodies.vy[a];
        double mass = bodies.mass[a];
        double inverse = bodies.inverseMass[a];
        double approach = nx * vax + ny * vay;
        if (!(approach > 0)) {                        // an earlier impact of the same batch has reversed it
            removeResidualApproachToWall(bodies, a, wall, nx, ny);
            return;
        }
        double first = approach / inverse;
        double restitution = restitutionRule.atWall(bodies, a, wall);
        double second = wallImpulse.secondStep(first, restitution);
        double impulse = first + second;
        applyWallImpulse(bodies, a, nx, ny, restitution, impulse);
        removeResidualApproachToWall(bodies, a, wall, nx, ny);
        double gap = wall.gap(ax, ay, bodies.radius[a]);
        double reach = gap + bodies.radius[a];
        sink.impact(time, bodies.id(a), ~w, ax, ay, ax + nx * reach, ay + ny * reach, nx, ny, impulse,
            inverse * (second * second - first * first) / 2, mass, Double.POSITIVE_INFINITY,
            vax, vay, bodies.vx[a], bodies.vy[a], 0, 0, 0, 0);
        sink.knot(bodies.id(a), time, ax, ay);
        correction.correctFromWall(this, bodies, a, nx, ny, gap, time, sink);
    }

    /** Removes a wall penetration that is a rounding error; otherwise those of thousands of impacts would add up. */
    void cancelRoundingPenetration(Bodies bodies, int a, double nx, double ny, double gap) {
        if (gap < 0 && -gap < ROUNDING * (Math.abs(bodies.x[a]) + Math.abs(bodies.y[a]) + bodies.radius[a])) {
            bodies.x[a] += nx * gap;
            bodies.y[a] += ny * gap;
        }
    }

    /** Moves a body that touches or penetrates a wall to contact, and away from it by 2 {@code pushOut}. */
    void correctFromWall(Bodies bodies, int a, double nx, double ny, double gap, double time, TurnSink sink) {
        if (gap <= 0) {
            moveAlongNormal(bodies, a, nx, ny, gap - 2 * pushOut, time, sink);
        }
    }

    /**
     * Moves each body of a touching pair by half of the overlap plus {@code pushOut}; against infinite mass, the other
     * by twice as much.
     */
    void correctPair(Bodies bodies, int a, int b, double nx, double ny, double distance, double time, TurnSink sink) {
        double overlap = bodies.radius[a] + bodies.radius[b] - distance;
        if (overlap >= 0) {
            double each = overlap / 2 + pushOut;
            double byA = bodies.mass[b] == Double.POSITIVE_INFINITY ? -2 * each : -each;
            double byB = bodies.mass[a] == Double.POSITIVE_INFINITY ? 2 * each : each;
            moveAlongNormal(bodies, a, nx, ny, byA, time, sink);
            moveAlongNormal(bodies, b, nx, ny, byB, time, sink);
        }
    }

    /*
     * Rounding can leave a residual approach after an impulse that should have ended it (restitution 0 or nearly 0).
     * Where only approach reacts, the pair would react again and again at the same instant, each impulse too small to
     * change a digit of a velocity, until the bound on impacts. So the residual approach is removed in steps that
     * double, starting from one unit in the last place of the speeds: an error as large as that of storing them.
     */

    /** @param speeds sum of the velocity components of both before the impact, in magnitude: sets the first step */
    void removeResidualApproach(Bodies bodies, int a, int b, double nx, double ny, double speeds) {
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

    private static void removeResidualApproachToWall(Bodies bodies, int a, Wall wall, double nx, double ny) {
        double speed = Math.abs(bodies.vx[a]) + Math.abs(bodies.vy[a]);
        double step = -Math.ulp(speed);
        while (TimeOfImpact.wall(wall, bodies.x[a], bodies.y[a], bodies.vx[a], bodies.vy[a], bodies.radius[a]) == 0) {
            bodies.vx[a] += nx * step;
            bodies.vy[a] += ny * step;
            step *= 2;
            if (-step > speed) {                      // no velocity separates it from this wall but rest
                bodies.vx[a] = 0;
                bodies.vy[a] = 0;
                return;
            }
        }
    }

    private static void moveAlongNormal(Bodies bodies, int body, double nx, double ny, double by, double time,
                                  TurnSink sink) {
        if (bodies.inverseMass[body] > 0) {
            bodies.x[body] += nx * by;
            bodies.y[body] += ny * by;
            sink.knot(bodies.id(body), time, bodies.x[body], bodies.y[body]);
        }
    }
}
