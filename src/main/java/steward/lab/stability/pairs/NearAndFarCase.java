package steward.lab.stability.pairs;

import java.util.Locale;
import steward.lab.trial.Finding;
import steward.lab.trial.PairSampler;
import steward.lab.trial.PairTally;
import steward.lab.trial.Progress;
import steward.lab.trial.RunLength;
import steward.lab.trial.Rung;
import steward.lab.trial.StabilityCase;
import steward.numerics.SplitMix64;
import steward.physics.Bodies;

/** Times of impact where the terms of the quadratic cancel: minimally apart, very far apart, far from the origin. */
public final class NearAndFarCase implements StabilityCase {

    private static final long SEED = 3;

    @Override
    public String name() {
        return "gaps, distances";
    }

    @Override
    public String demand() {
        return "gap 1e-12 R closing at 1e-9; separation 1e7 R; coordinates near 1e9 with separation 1e3: "
            + "time of impact within 0.51 ulp on exact, reported on the others";
    }

    @Override
    public Finding run(Rung rung, RunLength size, Progress progress) {
        StringBuilder text = new StringBuilder("ulp");
        boolean met = true;
        String[] names = {"gap", "far", "1e9"};
        for (int family = 0; family < names.length; family++) {
            PairTally tally = new PairTally(rung);
            SplitMix64 random = new SplitMix64(SEED + family);
            for (int n = 0; n < size.pick(4000, 100_000, 2_000_000); n++) {
                tally.add(pair(family, random), false);
            }
            met &= tally.isRight() && tally.timeUlps() <= Rung.EXACT_ULPS;
            progress.reached((family + 1.0) / names.length, text::toString);
            text.append(String.format(Locale.ROOT, "; %s %.3g", names[family], tally.timeUlps()))
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
            default -> PairSampler.passing(random, 2, share, 1e3, time, 1e9 * (0.5 + random.nextDouble()),
                1e9 * (0.5 + random.nextDouble()));
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
