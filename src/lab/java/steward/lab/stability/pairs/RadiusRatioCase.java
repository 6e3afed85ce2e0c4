package steward.lab.stability.pairs;

import steward.lab.trial.Finding;
import steward.lab.trial.PairSampler;
import steward.lab.trial.PairTally;
import steward.lab.trial.Progress;
import steward.lab.trial.RunLength;
import steward.lab.trial.Rung;
import steward.lab.trial.StabilityCase;
import steward.numerics.SplitMix64;
import steward.physics.Bodies;

/**
 * Stability case of a body of 1e6 u and one of 1e-6 u: hits across the front, near its edge, and from near and far.
 */
public final class RadiusRatioCase extends StabilityCase {

    private static final long SEED = 8;

    public RadiusRatioCase() {
        super("radius ratio 1e12",
            "0 wrong decisions and time of impact within 0.51 ulp on exact, counted on the others");
    }

    @Override
    public Finding run(Rung rung, RunLength size, Progress progress) {
        PairTally tally = new PairTally(rung);
        SplitMix64 random = new SplitMix64(SEED);
        for (int n = 0; n < size.pick(5000, 100_000, 2_000_000); n++) {
            double angle = 2 * random.nextDouble() - 1;
            double off = StrictMath.pow(10, -random.nextInt(1, 12));
            double share = n % 3 == 0 ? 1 - off : n % 3 == 1 ? 1 + off : angle;
            Bodies bodies = new Bodies(2);
            double along = 1e6 + PairSampler.around(random, random.nextInt(-6, 6));
            bodies.add(0, 0, 1e6, 1);
            bodies.add(along, share * 1e6, 1e-6, 1);
            bodies.setVelocity(1, -along / (0.2 + 0.7 * random.nextDouble()), angle);
            tally.add(bodies, false);
        }
        return tally.seen();
    }
}
