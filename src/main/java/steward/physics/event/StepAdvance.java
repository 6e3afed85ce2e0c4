package steward.physics.event;

import steward.physics.Advance;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.Reaction;
import steward.physics.TurnSink;
import steward.physics.Wall;
import steward.physics.impulse.Collision;
import steward.physics.impulse.Touch;
import steward.physics.time.PairTime;
import steward.physics.time.TimeOfImpact;

/**
 * The cheapest way to advance: a turn is k equal steps, and after each the bodies that then touch react, under the same
 * law as everywhere. For searches, which look at many turns and can do with less: an impact happens up to 1/k late, at
 * an overlap, and a body that flies through another within one step is not noticed at all.
 *
 * <p>In each step, everybody flies straight for 1/k. Then the pairs that touch and approach (or only touch, where the
 * law lets separating pairs react) are listed in the order of the scan, and behind them bodies that touch walls. They
 * react in this order, each if it still does so after those before it. Whoever reacts is moved out of the overlap, half
 * each and the law's {@code pushOut} more, also under a law that has none: an overlap is the rule here.
 *
 * <p>A turn ends by construction: every step looks once, so that a turn has at most k impacts per pair and per body and
 * wall; the law's batch window and bound on impacts mean nothing here. After a {@link Reaction} that has changed the
 * bodies the step looks once more, at most once per body.
 *
 * <p>Caveats: what touches at the start of a turn reacts only after the first step. With k steps, momentum is as well
 * kept as elsewhere; energy is, as far as impulses go, but positions are moved.
 */
public final class StepAdvance implements Advance {

    /** The most steps that a turn can have. */
    public static final int MOST_STEPS = 1024;

    /** Scans list what happens up to the end of a turn: seen from the end, only what is there already. */
    private static final double END = 1;

    private final int steps;
    private final Wall[] walls;
    private final PairTime overlap;
    private final Scan[] scans;
    private final ImpactQueue queue = new ImpactQueue.WithinWindow(0);
    private final Touch touch;

    /**
     * @param parts their arithmetic is not used
     * @param steps 1..{@link #MOST_STEPS}
     * @throws IllegalArgumentException if the number of steps is out of range
     */
    public StepAdvance(PhysicsParts parts, int steps) {
        if (steps < 1 || steps > MOST_STEPS) {
            throw new IllegalArgumentException(steps + " steps, expected 1.." + MOST_STEPS);
        }
        this.steps = steps;
        walls = parts.walls().toArray(new Wall[0]);
        ImpactLaw law = parts.law();
        overlap = law.separatingPairsReact() ? new PairTime.Overlap() : new PairTime.ClosingOverlap();
        scans = Scan.of(parts, overlap);
        touch = Touch.of(parts,
            new Collision(Double.isNaN(law.pushOut()) ? law.withPushOut(0) : law, walls), walls);
    }

    @Override
    public void turn(Bodies bodies, TurnSink sink) {
        double step = 1.0 / steps;
        for (int k = 1; k <= steps; k++) {
            EventAdvance.fly(bodies, step);
            touch.flown(bodies);
            double time = (double) k / steps;
            int looks = 1 + bodies.size();
            while (!react(bodies, time, sink) && looks > 1) {
                looks--;
            }
        }
    }

    /** Lets everybody who touches react. @return false if the bodies were altered */
    private boolean react(Bodies bodies, double time, TurnSink sink) {
        queue.clear();
        for (Scan scan : scans) {
            scan.find(bodies, END, queue);
        }
        int count = queue.next();
        for (int k = 0; k < count; k++) {
            int a = queue.a(k);
            int b = queue.b(k);
            if (touches(bodies, a, b) && !touch.happens(bodies, a, b, time, sink)) {
                return false;
            }
        }
        return true;
    }

    private boolean touches(Bodies bodies, int a, int b) {
        double until = b >= 0 ? overlap.until(bodies, a, b) : TimeOfImpact.wall(walls[~b], 
            bodies.x[a], bodies.y[a], bodies.vx[a], bodies.vy[a], bodies.radius[a]);
        return until == 0;
    }
}
