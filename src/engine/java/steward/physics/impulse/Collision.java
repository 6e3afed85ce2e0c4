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
 * Reaction of a pair, or of a body and a wall, under a law. An {@link ImpulseSolver} computes the impulse in the
 * arithmetic of the rung; then come the rest of the approach, the record, and positional correction.
 */
public final class Collision {

    /**
     * A wall penetration below this, relative to the coordinates, is a rounding error: some units in the last place.
     */
    static final double ROUNDING = 0x1p-46;

    /** Takes what is left of an approach. */
    private static final Impulse INELASTIC = new Impulse.Restituted();

    private final ImpulseSolver solver;
    /** {@code null} where no force acts. */
    private final Accelerations accelerations;
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

    private Collision(ImpactLaw law, Wall[] walls, ImpulseSolver solver, Accelerations accelerations) {
        this.solver = solver;
        this.accelerations = accelerations;
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
        this(law, walls, new PlainSolver(), null);
    }

    /**
     * The reactions of an arithmetic.
     *
     * @param lows          what rounding took from the places of bodies, in the arithmetic {@code EXACT}
     * @param accelerations of the turn, or {@code null}
     */
    public static Collision of(ImpactLaw law, Arithmetic arithmetic, Wall[] walls, LowParts lows,
                               Accelerations accelerations) {
        return new Collision(law, walls, switch (arithmetic) {
            case OFFICIAL -> new PlainSolver.Official();
            case DOUBLE -> law.minimumImpulse() > 0 ? new PlainSolver() : new CompensatedSolver(false);
            case COMPENSATED -> law.minimumImpulse() > 0 ? new PlainSolver() : new CompensatedSolver(true);
            case EXACT -> new ExactSolver(law, new ExactPairs(law), new ExactWalls(walls), lows);
        }, accelerations);
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
        double half = toInstant(bodies, a, b, time);
        double vax = bodies.vx[a];
        double vay = bodies.vy[a];
        double vbx = bodies.vx[b];
        double vby = bodies.vy[b];
        double massA = bodies.mass[a];
        double massB = bodies.mass[b];
        double restitution = restitutionRule.betweenBodies(bodies, a, b);
        if (accelerations == null) {
            solver.exchange(bodies, a, b, restitution, pairImpulse, solved);
        } else {
            exchangeUnderForces(bodies, a, b, restitution, half);
        }
        if (separates) {
            solver.separate(bodies, a, b, solved.normalX, solved.normalY,
                Math.abs(vax) + Math.abs(vay) + Math.abs(vbx) + Math.abs(vby));
        }
        double pushA = -solved.impulse * bodies.inverseMass[a];
        double pushB = solved.impulse * bodies.inverseMass[b];
        sink.impact(time, bodies.id(a), bodies.id(b), ax, ay, bx, by, solved.normalX, solved.normalY, solved.impulse,
            solved.energy, massA, massB, vax, vay, after(bodies.vx[a], vax, solved.normalX * pushA),
            after(bodies.vy[a], vay, solved.normalY * pushA), vbx, vby,
            after(bodies.vx[b], vbx, solved.normalX * pushB), after(bodies.vy[b], vby, solved.normalY * pushB));
        sink.knot(bodies.id(a), time, ax, ay);
        sink.knot(bodies.id(b), time, bx, by);
        if (corrects) {
            correctPair(bodies, a, b, time, sink);
        }
    }

    /** Gives the two the velocities of an instant. @return its fraction of the turn, less a half */
    private double toInstant(Bodies bodies, int a, int b, double time) {
        double half = time - 0.5;
        if (accelerations != null) {
            accelerations.add(bodies, a, half);
            if (b >= 0) {
                accelerations.add(bodies, b, half);
            }
        }
        return half;
    }

    /**
     * The velocity after an impact, as it is recorded: where forces act, that of the instant, since the one that the
     * body has is of its flight.
     */
    private double after(double stored, double before, double push) {
        return accelerations == null ? stored : before + push;
    }

    /**
     * An impact from the velocities of its instant; if the flights after it approach, the hop ends in this turn, and
     * what is left of the approach is taken, too.
     */
    private void exchangeUnderForces(Bodies bodies, int a, int b, double restitution, double half) {
        double vax = bodies.vx[a];
        double vay = bodies.vy[a];
        double vbx = bodies.vx[b];
        double vby = bodies.vy[b];
        double impulse = 0;
        if (solver.areApproaching(bodies, a, b)) {
            solver.exchange(bodies, a, b, restitution, pairImpulse, solved);
            impulse = solved.impulse;
        }
        accelerations.leave(bodies, a, half, vax, vay);
        accelerations.leave(bodies, b, half, vbx, vby);
        if (impulse == 0 || separates && solver.areApproaching(bodies, a, b)) {
            solver.exchange(bodies, a, b, 0, INELASTIC, solved);
            impulse += solved.impulse;
        }
        double approach = solved.normalX * (vax - vbx) + solved.normalY * (vay - vby);
        solved.set(impulse, impulse * (impulse * (bodies.inverseMass[a] + bodies.inverseMass[b]) / 2 - approach));
    }

    /** As {@link #exchangeUnderForces}, at a wall. */
    private void exchangeWithWallUnderForces(Bodies bodies, int a, int w, Wall wall, double half) {
        double vx = bodies.vx[a];
        double vy = bodies.vy[a];
        double impulse = solver.exchangeWithWall(bodies, a, w, wall, restitutionRule.atWall(bodies, a, wall),
            wallImpulse, solved) ? solved.impulse : 0;
        accelerations.leave(bodies, a, half, vx, vy);
        if (solver.isPressed(bodies, a, w, wall) && solver.exchangeWithWall(bodies, a, w, wall, 0, INELASTIC, solved)) {
            impulse += solved.impulse;
        }
        double approach = solved.normalX * vx + solved.normalY * vy;
        solved.set(impulse, impulse * (impulse * bodies.inverseMass[a] / 2 - approach));
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
        double restitution = restitutionRule.atWall(bodies, a, wall);
        if (slides && RimSliding.slide(bodies, a, w, wall, restitution, time, recordsSlides, sink)) {
            solver.forgetRounding(a);
            return;
        }
        double ax = bodies.x[a];
        double ay = bodies.y[a];
        double half = toInstant(bodies, a, ~w, time);
        double vax = bodies.vx[a];
        double vay = bodies.vy[a];
        boolean approaches = true;
        if (accelerations == null) {
            approaches = solver.exchangeWithWall(bodies, a, w, wall, restitution, wallImpulse, solved);
        } else {
            exchangeWithWallUnderForces(bodies, a, w, wall, half);
        }
        removeResidualApproachToWall(bodies, a, w, wall);
        if (!approaches) {                            // an earlier impact of the same batch has reversed it
            return;
        }
        double nx = solved.normalX;
        double ny = solved.normalY;
        double gap = wall.gap(ax, ay, bodies.radius[a]);
        double reach = gap + bodies.radius[a];
        double push = -solved.impulse * bodies.inverseMass[a];
        sink.impact(time, bodies.id(a), ~w, ax, ay, ax + nx * reach, ay + ny * reach, nx, ny, solved.impulse,
            solved.energy, bodies.mass[a], Double.POSITIVE_INFINITY, vax, vay, after(bodies.vx[a], vax, nx * push),
            after(bodies.vy[a], vay, ny * push), 0, 0, 0, 0);
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
