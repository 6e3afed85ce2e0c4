package steward.physics.event;

import steward.physics.Advance;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.Reaction;
import steward.physics.TurnSink;
import steward.physics.Wall;
import steward.physics.event.flight.PairSelection;
import steward.physics.impulse.Collision;
import steward.physics.impulse.ContactResponse;
import steward.physics.time.Magnitudes;
import steward.physics.time.PairTime;
import steward.physics.time.TimeOfImpact;

/**
 * Cheapest way to advance: a turn is k equal steps, and after each step overlapping pairs react, under the same law as
 * elsewhere. It is for search programs, which play many turns and need less accuracy: an impact happens up to 1/k late,
 * at an overlap, and a body that flies through another within one step is not noticed.
 *
 * <p>In each step, all bodies fly straight for 1/k. Then the pairs that touch and approach (or only touch, if the law
 * lets separating pairs react) are listed in the order of the scan, followed by the bodies that touch walls. They react
 * in this order, each if its condition still holds after the reactions before it. Positional correction is applied also
 * under a law without it: each body of a pair is moved by half of the overlap plus the law's {@code pushOut}, if any,
 * because overlaps are normal here.
 *
 * <p>A turn ends by construction: every step searches once, so that a turn has at most k impacts per pair and per body
 * and wall; the law's batch window and bound on impacts have no effect. After a {@link Reaction} that has changed the
 * bodies the step searches once more, at most once per body.
 *
 * <p>A turn with numbers whose squares leave the range of doubles is computed as on the event rungs (see {@link
 * Magnitudes}).
 *
 * <p>Caveats: a contact at the start of a turn reacts only after the first step. Momentum is conserved as in other
 * advances; energy is conserved by the impulses, but positions are moved.
 */
public final class StepAdvance implements Advance {

    /** The maximum number of steps in a turn. */
    public static final int MOST_STEPS = 1024;

    /** Scans list impacts up to the end of the turn; from the end itself, only present contacts. */
    private static final double END = 1;

    private final PhysicsParts parts;
    private final int steps;
    private final Wall[] walls;
    private final PairTime overlap;
    /** {@code null} if all can react. */
    private final PairSelection selection;
    private final Scan[] scans;
    private final ImpactQueue queue = new ImpactQueue(true, 0);
    private final ContactResponse response;

    /**
     * @param parts of the scene; their arithmetic is not used
     * @param steps 1..{@link #MOST_STEPS}
     * @throws IllegalArgumentException if the number of steps is out of range
     */
    public StepAdvance(PhysicsParts parts, int steps) {
        if (steps < 1 || steps > MOST_STEPS) {
            throw new IllegalArgumentException(steps + " steps, expected 1.." + MOST_STEPS);
        }
        this.parts = parts;
        this.steps = steps;
        walls = parts.walls().toArray(new Wall[0]);
        ImpactLaw law = parts.law();
        overlap = new PairTime.Overlap(!law.separatingPairsReact());
        scans = Scan.of(parts, overlap);
        selection = PairSelection.of(parts);
        response = ContactResponse.of(parts,
            new Collision(Double.isNaN(law.pushOut()) ? law.withPushOut(0) : law, walls), walls);
    }

    @Override
    public void turn(Bodies bodies, TurnSink sink) {
        if (!Magnitudes.fitPlainArithmetic(bodies)) {
            EventAdvance.inExactArithmetic(parts).turn(bodies, sink);
            return;
        }
        double step = 1.0 / steps;
        for (int k = 1; k <= steps; k++) {
            EventAdvance.fly(bodies, step);
            response.releaseSeparatedPairs(bodies);
            double time = (double) k / steps;
            int searches = 1 + bodies.size();
            while (!react(bodies, time, sink) && searches > 1) {
                searches--;
            }
        }
    }

    /** Lets all touching pairs react. @return false if a reaction altered the bodies */
    private boolean react(Bodies bodies, double time, TurnSink sink) {
        queue.clear();
        for (Scan scan : scans) {
            scan.find(bodies, END, queue);
        }
        int count = queue.nextBatch();
        for (int k = 0; k < count; k++) {
            int a = queue.a(k);
            int b = queue.b(k);
            if (touches(bodies, a, b) && !response.react(bodies, a, b, time, sink)) {
                return false;
            }
        }
        return true;
    }

    private boolean touches(Bodies bodies, int a, int b) {
        double until = b >= 0 ? overlap.until(bodies, a, b, PairSelection.radius(selection, bodies, a, b),
            PairSelection.radius(selection, bodies, b, a)) : TimeOfImpact.wall(walls[~b],
            bodies.x[a], bodies.y[a], bodies.vx[a], bodies.vy[a], bodies.radius[a]);
        return until == 0;
    }
}
