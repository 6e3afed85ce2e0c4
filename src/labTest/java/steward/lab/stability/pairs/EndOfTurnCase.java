package steward.lab.stability.pairs;

import steward.lab.trial.Finding;
import steward.lab.trial.PairSampler;
import steward.lab.trial.PairTally;
import steward.lab.trial.RunLength;
import steward.lab.trial.Rung;
import steward.lab.trial.StabilityCase;
import steward.numerics.DoubleDouble;
import steward.numerics.SplitMix64;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;
import steward.physics.time.ExactPairs;

/** Stability case of impacts at the end of the turn, a few units in the last place before or after it. */
public final class EndOfTurnCase extends StabilityCase {

    private static final long SEED = 33;
    private static final int MOST_ULPS = 4;

    public EndOfTurnCase() {
        super("end of the turn",
            "impacts at t = 1, and places up to " + MOST_ULPS + " ulps off: 0 wrong decisions on exact and "
            + "compensated, counted on the others");
    }

    @Override
    public Finding run(Rung rung, RunLength size) {
        PairTally tally = new PairTally(rung);
        SplitMix64 random = new SplitMix64(SEED);
        ExactPairs pairs = new ExactPairs(ImpactLaw.PHYSICS);
        DoubleDouble until = new DoubleDouble();
        int count = size.pick(3_000, 60_000, 1_000_000);
        for (int n = 0; n < count; n++) {
            double touch = PairSampler.around(random, random.nextInt(-1, 4));
            Bodies bodies = PairSampler.passing(random, touch, 0.9 * random.nextDouble(),
                touch * 3 * random.nextDouble(), 0.3 + 0.6 * random.nextDouble(), touch * (random.nextDouble() - 0.5),
                10 * touch * (random.nextDouble() - 0.5));
            if (!pairs.exactTime(bodies, 0, 1, until)) {
                continue;                                  // it touches already, and separates
            }
            for (int k = 0; k < 2; k++) {
                bodies.setVelocity(k, bodies.vx[k] * until.high(), bodies.vy[k] * until.high());
            }
            int ulps = random.nextInt(2 * MOST_ULPS + 1) - MOST_ULPS;
            bodies.setPosition(0, bodies.x[0] + ulps * Math.ulp(bodies.x[0]), bodies.y[0]);
            tally.add(bodies, false);
        }
        return Finding.of(rung.isExact() || rung.arithmetic() == Arithmetic.COMPENSATED, tally.isRight(), tally.text());
    }
}
