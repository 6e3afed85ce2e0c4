package steward.lab.stability.pairs;

import java.util.Locale;
import steward.lab.trial.Finding;
import steward.lab.trial.PairSampler;
import steward.lab.trial.PairTally;
import steward.lab.trial.RunLength;
import steward.lab.trial.Rung;
import steward.lab.trial.StabilityCase;
import steward.numerics.SplitMix64;
import steward.physics.Bodies;

/**
 * Stability case of times of impact whose quadratic cancels: bodies minimally apart, very far apart, far from the
 * origin.
 */
public final class NearAndFarCase extends StabilityCase {

    private static final long SEED = 3;
    /** From this family on, positions and velocities are compared too. */
    private static final int WHOLE = 3;
    private static final double MOST_ULPS = 1.51;

    public NearAndFarCase() {
        super("gaps, distances",
            "gap 1e-12 R closing at 1e-9; separation 1e7 R; coordinates near 1e9 with separation 1e3: time of impact"
            + " within 0.51 ulp on exact, reported on the others. At distances and coordinates of 1e12: no wrong "
            + "decision, positions within 1 and velocities within 1.51 ulp");
    }

    @Override
    public Finding run(Rung rung, RunLength size) {
        StringBuilder text = new StringBuilder("ulp");
        boolean met = true;
        String[] names = {"gap", "far", "1e9", "1e12 apart", "at 1e12"};
        for (int family = 0; family < names.length; family++) {
            PairTally tally = new PairTally(rung);
            SplitMix64 random = new SplitMix64(SEED + family);
            int number = size.pick(4000, 100_000, 2_000_000) / (family >= WHOLE ? 4 : 1);
            for (int n = 0; n < number; n++) {
                tally.add(pair(family, random), family >= WHOLE && rung.isExact());
            }
            met &= tally.isRight() && tally.timeUlps() <= Rung.EXACT_ULPS
                && tally.positionUlps() <= 1 && tally.velocityUlps() <= MOST_ULPS;
            text.append(String.format(Locale.ROOT, "; %s %.3g", names[family], tally.timeUlps()))
                .append(tally.positionUlps() == 0 ? "" : String.format(Locale.ROOT, " (position %.3g, velocity %.3g)",
                    tally.positionUlps(), tally.velocityUlps()))
                .append(tally.wrong() > 0 ? ", wrong " + tally.wrong() : "");
        }
        return Finding.of(rung.isExact(), met, text.toString().replaceFirst("ulp;", "ulp:"));
    }

    private static Bodies pair(int family, SplitMix64 random) {
        double share = 0.99 * random.nextDouble();
        double time = 0.1 + 0.8 * random.nextDouble();
        return switch (family) {
            case 0 -> hairApart(random);
            case 1 -> PairSampler.passing(random, 1, share, 1e7, time, 0, 0);
            case 2 -> PairSampler.passing(random, 2, share, 1e3, time, 1e9 * (0.5 + random.nextDouble()),
                1e9 * (0.5 + random.nextDouble()));
            case 3 -> PairSampler.passing(random, 100, share, 1e12, time, 0, 0);
            default -> PairSampler.passing(random, 800, share, 1e4, time, 1e12 * (0.5 + random.nextDouble()),
                1e12 * (0.5 + random.nextDouble()));
        };
    }

    /** Side by side on the x axis, with the smallest gap that can be stored, about 1e-12 R. */
    private static Bodies hairApart(SplitMix64 random) {
        Bodies bodies = new Bodies(2);
        bodies.add(0, 0, 0.5, 1);
        bodies.add(1 + 1e-12 * (0.5 + random.nextDouble()), 0, 0.5, 1);
        bodies.setVelocity(0, 1e-9 * (0.5 + random.nextDouble()), 1e-9 * (random.nextDouble() - 0.5));
        return bodies;
    }
}
