package steward.lab.stability.pairs;

import steward.lab.trial.Finding;
import steward.lab.trial.PairSampler;
import steward.lab.trial.PairTally;
import steward.lab.trial.RunLength;
import steward.lab.trial.Rung;
import steward.lab.trial.StabilityCase;
import steward.numerics.SplitMix64;
import steward.physics.Bodies;

/** Stability case of random pairs of all sizes, speeds, masses and offsets, a third of them grazing. */
public final class RandomPairsCase extends StabilityCase {

    private static final long SEED = 20_000;
    /** How many pairs share a seed. */
    private static final int BLOCK = 10_000;
    /** Powers of two that scale lengths and speeds: up to what a sum of squares can hold, and beyond. */
    private final int exponents;

    /** @param exponents lengths range from about 2^-exponents to 2^exponents */
    public RandomPairsCase(int exponents) {
        super("random pairs, 2^+-" + exponents,
            "0 wrong decisions on exact, time, positions, impulse and velocities within 0.51 ulp; counted on the "
            + "others; seeds " + SEED + " upward, " + BLOCK + " pairs each");
        this.exponents = exponents;
    }

    @Override
    public Finding run(Rung rung, RunLength size) {
        int every = size.pick(250, 50, 50);
        int blocks = rung.isExact() ? size.pick(50, 500, 5_000) : size.pick(2, 50, 500);
        PairTally tally = new PairTally(rung);
        for (int block = 0; block < blocks; block++) {
            SplitMix64 random = new SplitMix64(SEED + block);
            for (int n = 0; n < BLOCK; n++) {
                tally.add(pair(random), n % every == 0);
            }
        }
        return tally.seen();
    }

    private Bodies pair(SplitMix64 random) {
        double touch = 1 + random.nextDouble();
        double off = StrictMath.pow(10, -random.nextInt(1, 16));
        double share = switch (random.nextInt(6)) {
            case 0 -> 1 - off;
            case 1 -> 1 + off;
            default -> 1.2 * random.nextDouble();
        };
        double gap = random.nextInt(2) == 0 ? PairSampler.around(random, random.nextInt(-14, 5))
            : 5 * random.nextDouble();
        double far = random.nextInt(4) == 0 ? PairSampler.around(random, random.nextInt(0, 6)) : 0;
        Bodies bodies = PairSampler.passing(random, touch, random.nextInt(2) == 0 ? share : -share, gap,
            0.05 + 1.1 * random.nextDouble(), far, far * (random.nextDouble() - 0.5));
        double scale = Math.scalb(1.0, random.nextInt(-exponents, exponents));
        for (int k = 0; k < 2; k++) {
            bodies.setPosition(k, bodies.x[k] * scale, bodies.y[k] * scale);
            bodies.setVelocity(k, bodies.vx[k] * scale, bodies.vy[k] * scale);
            bodies.setRadius(k, bodies.radius[k] * scale);
            bodies.setMass(k, random.nextInt(2) == 0 ? 1 : PairSampler.around(random, random.nextInt(-20, 20)));
        }
        return bodies;
    }
}
