package steward.physics.impulse;

import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;
import steward.physics.TurnSink;
import steward.physics.Wall;
import steward.physics.time.ExactPairs;
import steward.physics.time.ExactWalls;
import steward.physics.time.LowParts;

/**
 * The reaction of a pair, or of a body and a wall, under a law: the impulse, which an {@link ImpulseSolver} computes in
 * the arithmetic of the rung; what of the approach is left after it; the record; positional correction.
 */
public final class Collision {

    /**
     * A wall penetration below this, relative to the coordinates, is a rounding error: some units in the last place.
     */
    static final double ROUNDING = 0x1p-46;

    private final ImpulseSolver solver;
    private final SolvedImpulse solved = new SolvedImpulse();
    private final Impulse pairImpulse;
    private final Impulse wallImpulse;
    private final RestitutionRule restitutionRule;
    /** Only approach reacts, so a residual approach would react again at once: it is removed. */
    private final boolean separates;
    private final boolean corrects;
    private final double pushOut;
    private final Wall[] walls;
    /** True if bodies can slide along an arena. */
    private final boolean slides;
    /** True if the contacts of a slide are impacts: where bodies rest they are not, as on a straight wall. */
    private final boolean recordsSlides;

    private Collision(ImpactLaw law, Wall[] walls, ImpulseSolver solver) {
        this.solver = solver;
        pairImpulse = Impulse.of(law, true);
        wallImpulse = Impulse.of(law, law.minimumImpulseAtWalls());
        restitutionRule = RestitutionRule.of(law);
        separates = !law.separatingPairsReact();
        corrects = !Double.isNaN(law.pushOut());
        pushOut = law.pushOut();
        this.walls = walls;
        slides = RimSliding.isPossible(law, walls);
        recordsSlides = !law.bodiesRest();
    }

    /** With the expressions of the published official referee in their order, but for its change of velocity. */
    public Collision(ImpactLaw law, Wall[] walls) {
        this(law, walls, new PlainSolver());
    }

    /** The reactions of an arithmetic other than {@code EXACT}. */
    public static Collision of(ImpactLaw law, Arithmetic arithmetic, Wall[] walls) {
        return new Collision(law, walls, switch (arithmetic) {
            case OFFICIAL -> new PlainSolver.Official();
            case DOUBLE -> law.minimumImpulse() > 0 ? new PlainSolver() : new CompensatedSolver(false);
            case COMPENSATED -> law.minimumImpulse() > 0 ? new PlainSolver() : new CompensatedSolver(true);
            case EXACT -> throw new IllegalArgumentException("exact reactions need exact times: ofExact");
        });
    }

    /** The reactions of the arithmetic {@code EXACT}. */
    public static Collision ofExact(ImpactLaw law, Wall[] walls, ExactPairs pairs, ExactWalls wallTimes,
                                    LowParts lows) {
        return new Collision(law, walls, new ExactSolver(law, pairs, wallTimes, lows));
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
        double vax = bodies.vx[a];
        double vay = bodies.vy[a];
        double vbx = bodies.vx[b];
        double vby = bodies.vy[b];
        double massA = bodies.mass[a];
        double massB = bodies.mass[b];
        solver.exchange(bodies, a, b, restitutionRule.betweenBodies(bodies, a, b), pairImpulse, solved);
        if (separates) {
            solver.separate(bodies, a, b, solved.normalX, solved.normalY,
                Math.abs(vax) + Math.abs(vay) + Math.abs(vbx) + Math.abs(vby));
        }
        sink.impact(time, bodies.id(a), bodies.id(b), ax, ay, bx, by, solved.normalX, solved.normalY, solved.impulse,
            solved.energy, massA, massB, vax, vay, bodies.vx[a], bodies.vy[a], vbx, vby,
            bodies.vx[b], bodies.vy[b]);
        sink.knot(bodies.id(a), time, ax, ay);
        sink.knot(bodies.id(b), time, bx, by);
        if (corrects) {
            correctPair(bodies, a, b, time, sink);
        }
    }

    /**
     * Moves each body of a touching pair by half of the overlap plus {@code pushOut}; against infinite mass, the other
     * by twice as much.
     */
    private void correctPair(Bodies bodies, int a, int b, double time, TurnSink sink) {
        double overlap = solver.overlap(bodies, a, b, solved);
        if (overlap >= 0) {
            double each = overlap / 2 + pushOut;
            move(bodies, a, bodies.mass[b] == Double.POSITIVE_INFINITY ? -2 * each : -each, time, sink);
            move(bodies, b, bodies.mass[a] == Double.POSITIVE_INFINITY ? 2 * each : each, time, sink);
        }
    }

    private void move(Bodies bodies, int body, double by, double time, TurnSink sink) {
        if (bodies.inverseMass[body] > 0) {
            solver.moveAlongNormal(bodies, body, by, solved);
            sink.knot(bodies.id(body), time, bodies.x[body], bodies.y[body]);
        }
    }

    public void reactWall(Bodies bodies, int a, int w, double time, TurnSink sink) {
        Wall wall = walls[w];
        if (slides && RimSliding.slide(bodies, a, w, wall, time, recordsSlides, sink)) {
            solver.forgetRounding(a);
            return;
        }
        double ax = bodies.x[a];
        double ay = bodies.y[a];
        double vax = bodies.vx[a];
        double vay = bodies.vy[a];
        boolean approaches = solver.exchangeWithWall(bodies, a, w, wall, restitutionRule.atWall(bodies, a, wall),
            wallImpulse, solved);
        removeResidualApproachToWall(bodies, a, w, wall);
        if (!approaches) {                            // an earlier impact of the same batch has reversed it
            return;
        }
        double nx = solved.normalX;
        double ny = solved.normalY;
        double gap = wall.gap(ax, ay, bodies.radius[a]);
        double reach = gap + bodies.radius[a];
        sink.impact(time, bodies.id(a), ~w, ax, ay, ax + nx * reach, ay + ny * reach, nx, ny, solved.impulse,
            solved.energy, bodies.mass[a], Double.POSITIVE_INFINITY, vax, vay, bodies.vx[a], bodies.vy[a], 0, 0, 0, 0);
        sink.knot(bodies.id(a), time, ax, ay);
        correctFromWall(bodies, a, gap, time, sink);
    }

    /**
     * Moves a body that touches or penetrates a wall to contact, and away from it by 2 {@code pushOut}. Without
     * positional correction only a penetration that is a rounding error is removed, where positions have such;
     * otherwise those of thousands of impacts would add up.
     */
    private void correctFromWall(Bodies bodies, int a, double gap, double time, TurnSink sink) {
        double size = Math.abs(bodies.x[a]) + Math.abs(bodies.y[a]) + bodies.radius[a];
        if (corrects) {
            double rounding = solver.keepsRounding() ? ROUNDING * size : 0;
            if (gap <= rounding) {
                move(bodies, a, (gap < -rounding ? gap : 0) - 2 * pushOut, time, sink);
            }
        } else if (gap < 0 && -gap < ROUNDING * size && !solver.keepsRounding()) {
            solver.moveAlongNormal(bodies, a, gap, solved);
        }
    }

    /** As {@link ImpulseSolver#separate}, from a wall. */
    private void removeResidualApproachToWall(Bodies bodies, int a, int w, Wall wall) {
        double speed = Math.abs(bodies.vx[a]) + Math.abs(bodies.vy[a]);
        double step = -Math.ulp(speed);
        while (solver.isPressed(bodies, a, w, wall)) {
            bodies.vx[a] += solved.normalX * step;
            bodies.vy[a] += solved.normalY * step;
            step *= 2;
            if (-step > speed) {                      // no velocity separates it from this wall but rest
                bodies.vx[a] = 0;
                bodies.vy[a] = 0;
                return;
            }
        }
    }
}
