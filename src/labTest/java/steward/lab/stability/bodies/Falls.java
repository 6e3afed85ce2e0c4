package steward.lab.stability.bodies;

import java.util.List;
import steward.lab.trial.OracleTurns;
import steward.lab.trial.Rung;
import steward.physics.Advance;
import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.Forces;
import steward.physics.HalfPlane;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.TurnLog;
import steward.physics.TurnSink;
import steward.physics.Wall;

/** World of bodies under gravity, played turn after turn for stability cases. */
final class Falls {

    static final ImpactLaw SOFT = ImpactLaw.PHYSICS.withRestitution(ImpactLaw.Restitution.MINIMUM);
    /** Speed below which a body is still, in u per turn. */
    static final double STILL = 1e-6;
    static final Wall FLOOR = new HalfPlane(0, 0, 0, -1, 1);

    final Bodies bodies;
    private final Forces forces;
    private final Advance advance;
    private final PhysicsParts parts;
    /** {@code null} if no turns are compared. */
    private OracleTurns truth;
    private int every;
    private int turns;

    /** @param gravity downwards, which is where y grows */
    Falls(Bodies bodies, Rung rung, boolean asCrowd, ImpactLaw law, double gravity, Wall... walls) {
        this.bodies = bodies;
        forces = new Forces(0, 0, 0, gravity);
        parts = new PhysicsParts(law, rung.arithmetic(), new Contacts(1), List.of(walls), null, true)
            .withForces(forces);
        advance = (asCrowd ? rung.crowdMaker() : rung.maker()).apply(parts);
    }

    /** Compares every so many turns with the oracle's. */
    Falls comparing(OracleTurns with, int everyTurns) {
        truth = with;
        every = everyTurns;
        return this;
    }

    /** A half-plane through the origin that rises to the left (1) or to the right (-1). */
    static Wall slope(double degrees, int side) {
        double angle = StrictMath.toRadians(degrees);
        return new HalfPlane(0, 0, side * StrictMath.sin(angle), -StrictMath.cos(angle), 1);
    }

    /** Adds a disc. */
    static void add(Bodies bodies, double x, double y, double mass, double restitution) {
        int k = bodies.add(x, y, 10, mass);
        bodies.setRestitution(k, restitution);
    }

    void turn() {
        turn(TurnSink.NONE);
    }

    void turn(TurnSink sink) {
        for (int k = 0; k < bodies.size(); k++) {
            forces.accelerate(bodies, k, 0, 0);
        }
        Bodies before = truth != null && turns++ % every == 0 ? bodies.copy() : null;
        advance.turn(bodies, sink);
        if (before != null) {
            truth.add(before, bodies, parts);
        }
    }

    /** Returns how many impacts a turn has. */
    int impacts(TurnLog log) {
        log.clear();
        turn(log);
        return log.impacts();
    }

    /** The speed of the fastest body. */
    double fastest() {
        double fastest = 0;
        for (int k = 0; k < bodies.size(); k++) {
            fastest = Math.max(fastest, Math.abs(bodies.vx[k]) + Math.abs(bodies.vy[k]));
        }
        return fastest;
    }

    /** Returns the first turn from which on nothing moves until the last one, or -1. */
    int playUntilStill(int turns) {
        int since = -1;
        for (int turn = 1; turn <= turns; turn++) {
            turn();
            since = fastest() >= STILL ? -1 : since < 0 ? turn : since;
        }
        return since;
    }
}
