package steward.lab.stability.crowds;

import steward.lab.trial.Finding;
import steward.lab.trial.Probe;
import steward.lab.trial.Progress;
import steward.lab.trial.RunLength;
import steward.lab.trial.Rung;
import steward.lab.trial.StabilityCase;
import steward.numerics.SplitMix64;
import steward.physics.Advance;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;
import steward.physics.Wall;

/**
 * Stability case of time reversal: five discs in a box fly n turns; then all velocities are reversed and they fly back.
 */
public final class TimeReversalCase extends StabilityCase {

    private static final long SEED = 15;
    private static final double OFF = 1e-6;
    private static final int MOST_TURNS = 200;

    public TimeReversalCase() {
        super("time reversal",
            "how many impacts there and back until the start is missed by 1e-6 u: reported on every rung");
    }

    @Override
    public Finding run(Rung rung, RunLength size, Progress progress) {
        int worlds = size.pick(10, 100, 1000);
        long sum = 0;
        long least = Long.MAX_VALUE;
        for (int n = 0; n < worlds; n++) {
            Bodies start = discs(new SplitMix64(SEED + n));
            long impacts = untilOff(rung, start);
            sum += impacts;
            least = Math.min(least, impacts);
        }
        return Finding.reported(worlds + " worlds, on average " + sum / worlds + " impacts, at least " + least);
    }

    private static long untilOff(Rung rung, Bodies start) {
        Advance advance = rung.advance(ImpactLaw.PHYSICS, Wall.box(1000, 1000, 1));
        for (int turns = 1;; turns++) {
            Bodies bodies = new Bodies(start.capacity());
            bodies.copyFrom(start);
            Probe probe = new Probe();
            for (int turn = 0; turn < turns; turn++) {
                advance.turn(bodies, probe);
            }
            long impacts = probe.impacts;
            reverse(bodies);
            for (int turn = 0; turn < turns; turn++) {
                advance.turn(bodies, probe);
            }
            if (distance(bodies, start) > OFF || turns == MOST_TURNS) {
                return impacts;
            }
        }
    }

    private static Bodies discs(SplitMix64 random) {
        Bodies bodies = new Bodies(5);
        for (int k = 0; k < 5; k++) {
            bodies.add(150 + 170 * k, 200 + 600 * random.nextDouble(), 80, 1 + random.nextInt(3));
            bodies.setVelocity(k, 600 * (random.nextDouble() - 0.5), 600 * (random.nextDouble() - 0.5));
        }
        return bodies;
    }

    private static void reverse(Bodies bodies) {
        for (int k = 0; k < bodies.size(); k++) {
            bodies.setVelocity(k, -bodies.vx[k], -bodies.vy[k]);
        }
    }

    private static double distance(Bodies bodies, Bodies start) {
        double most = 0;
        for (int k = 0; k < bodies.size(); k++) {
            most = Math.max(most, Math.max(Math.abs(bodies.x[k] - start.x[k]), Math.abs(bodies.y[k] - start.y[k])));
        }
        return most;
    }
}
