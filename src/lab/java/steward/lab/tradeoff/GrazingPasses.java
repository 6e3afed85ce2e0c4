package steward.lab.tradeoff;

import java.util.List;
import java.util.function.Supplier;
import steward.lab.trial.PairSampler;
import steward.numerics.SplitMix64;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;

/** Scene of the trade-off that no scene file can describe: two bodies that nearly touch. */
public final class GrazingPasses {

    public static final String NAME = "grazing";

    private static final long SEED = 4;
    private static final int ALL_STEPS = 1024;
    private static final PhysicsParts PARTS = new PhysicsParts(ImpactLaw.PHYSICS, Arithmetic.DOUBLE, new Contacts(1),
        List.of(), null, false);

    /** The sum of two radii, in u: two pods. */
    private static final double TOUCH = 800;

    private GrazingPasses() { }

    /** Law and contacts; there are no walls. */
    public static PhysicsParts parts() {
        return PARTS;
    }

    /**
     * Two of two pods' size that pass each other at R (1 - 10^-k) or R (1 + 10^-k), k = 1..16, in any direction; and
     * one state in 17 exactly tangent along an axis, or one unit in the last place to either side.
     */
    public static TradeoffScene scene() {
        SplitMix64 random = new SplitMix64(SEED);
        Supplier<Bodies> source = () -> {
            int k = 1 + random.nextInt(17);
            if (k == 17) {
                Bodies bodies = new Bodies(2);
                bodies.add(-TOUCH, TOUCH + (random.nextInt(3) - 1) * Math.ulp(TOUCH), TOUCH / 2, 1);
                bodies.add(0, 0, TOUCH / 2, 1);
                bodies.setVelocity(0, 2 * TOUCH, 0);
                return bodies;
            }
            double off = StrictMath.pow(10, -k);
            return PairSampler.passing(random, TOUCH, random.nextInt(2) == 0 ? 1 - off : 1 + off,
                TOUCH * random.nextDouble(), 0.1 + 0.8 * random.nextDouble(),
                16_000 * random.nextDouble(), 9_000 * random.nextDouble());
        };
        return new TradeoffScene(NAME, "two bodies that pass each other at R (1 -+ 10^-k), k = 1..16, or tangent",
            NAME, PARTS, null, source, 4000, 5, 20, ALL_STEPS);
    }
}
