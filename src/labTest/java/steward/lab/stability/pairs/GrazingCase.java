package steward.lab.stability.pairs;

import steward.lab.trial.Finding;
import steward.lab.trial.PairSampler;
import steward.lab.trial.PairTally;
import steward.lab.trial.RunLength;
import steward.lab.trial.Rung;
import steward.lab.trial.StabilityCase;
import steward.numerics.SplitMix64;
import steward.physics.Arithmetic;
import steward.physics.Bodies;

/**
 * Stability case of passes that nearly touch. Distances are R (1 - 10^-k), R (1 + 10^-k), exactly tangent, and one unit
 * in the last place to either side.
 */
public final class GrazingCase extends StabilityCase {

    private static final long SEED = 2;
    /** Of velocities: the rounding, and one unit in the last place where it leaves an approach. */
    private static final double MOST_ULPS = 1.51;

    public GrazingCase() {
        super("grazing passes",
            "R(1 +- 10^-k), k = 1..16, and tangent +- 1 ulp: 0 wrong decisions on exact and compensated, counted on "
            + "the others. On exact, positions and velocities are within 0.51 ulp, and velocities within 1.51 ulp "
            + "if in contact but for a rounding");
    }

    @Override
    public Finding run(Rung rung, RunLength size) {
        PairTally tally = new PairTally(rung);
        SplitMix64 random = new SplitMix64(SEED);
        for (int k = 1; k <= 16; k++) {
            for (int n = 0; n < size.pick(400, 10_000, 200_000); n++) {
                double off = StrictMath.pow(10, -k);
                double touch = PairSampler.around(random, random.nextInt(-3, 4));
                tally.add(PairSampler.passing(random, touch, n % 2 == 0 ? 1 - off : 1 + off,
                    touch * 3 * random.nextDouble(),
                    0.1 + 0.8 * random.nextDouble(), base(random, touch), base(random, touch)),
                    rung.isExact() && n % 10 == 0);
            }
        }
        for (int n = 0; n < size.pick(400, 10_000, 200_000); n++) {
            tangents(tally, random);
        }
        PairTally contacts = new PairTally(rung);
        for (int n = 0; n < size.pick(2_000, 50_000, 1_000_000); n++) {
            contacts.add(contact(random), rung.isExact());
        }
        return Finding.of(rung.isExact() || rung.arithmetic() == Arithmetic.COMPENSATED, tally.isRight()
            && !(rung.isExact() && (contacts.wrong() > 0 || contacts.velocityUlps() > MOST_ULPS
            || Math.max(tally.positionUlps(), tally.velocityUlps()) > Rung.EXACT_ULPS)),
            tally.text() + "; at rounding distance " + contacts.text());
    }

    /**
     * Two that touch but for a rounding, or overlap by one, at coordinates up to 1e12, and graze each other by a
     * cosine of 1 to 1e-17.
     */
    private static Bodies contact(SplitMix64 random) {
        double angle = 2 * Math.PI * random.nextDouble();
        double cos = StrictMath.cos(angle);
        double sin = StrictMath.sin(angle);
        double base = random.nextInt(2) * 1e12 * random.nextDouble();
        double radius = 1 + 400 * random.nextDouble();
        double other = 1 + 400 * random.nextDouble();
        double distance = (radius + other) * (1 + (random.nextInt(3) - 1) * 1e-14);
        double speed = 100 * random.nextDouble();
        double inward = speed * StrictMath.pow(10, -17 * random.nextDouble());
        Bodies bodies = new Bodies(2);
        bodies.add(base, base, radius, 1 + random.nextDouble());
        bodies.add(base + distance * cos, base + distance * sin, other, 1 + random.nextDouble());
        bodies.setVelocity(0, inward * cos - speed * sin, inward * sin + speed * cos);
        return bodies;
    }

    private static double base(SplitMix64 random, double touch) {
        return random.nextInt(2) == 0 ? 0 : touch * 20 * (random.nextDouble() - 0.5);
    }

    /** Along x, and along (4, 3) with an offset of touch (-3, 4) / 5: exact for a multiple of 5. */
    private static void tangents(PairTally tally, SplitMix64 random) {
        double touch = 5 * (1 + random.nextInt(1000));
        double scale = 1 + random.nextInt(50);
        for (int hair = -1; hair <= 1; hair++) {
            double offset = touch + hair * Math.ulp(touch);
            tally.add(pair(-40 * scale, offset, 160 * scale, 0, touch), false);
            double x = -3 * (touch / 5);
            tally.add(pair(x - 40 * scale + hair * Math.ulp(x), 4 * (touch / 5) - 30 * scale, 80 * scale, 60 * scale,
                touch), false);
        }
    }

    private static Bodies pair(double x, double y, double vx, double vy, double touch) {
        Bodies bodies = new Bodies(2);
        bodies.add(x, y, touch * 0.5, 1);
        bodies.add(0, 0, touch * 0.5, 1);
        bodies.setVelocity(0, vx, vy);
        return bodies;
    }
}
