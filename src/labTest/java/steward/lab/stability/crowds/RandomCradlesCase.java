package steward.lab.stability.crowds;

import java.util.Locale;
import java.util.stream.IntStream;
import steward.lab.trial.Finding;
import steward.lab.trial.Probe;
import steward.lab.trial.RunLength;
import steward.lab.trial.Rung;
import steward.lab.trial.StabilityCase;
import steward.numerics.SplitMix64;
import steward.physics.Advance;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;

/**
 * Stability case of Newton's cradle with random numbers: equal bodies in a row along an axis, hit by another. Radius,
 * place, gaps and speed are arbitrary. Whatever the rounding of positions makes of the gaps, all impacts are central,
 * so in each one the two exchange their velocities, to the bit.
 */
public final class RandomCradlesCase extends StabilityCase {

    private static final long SEED = 15;
    private static final int TOUCHING = 26;
    private static final double ROUNDING = 0x1p-40;
    private static final int[] LENGTHS = {5, 24, 100, 200};

    public RandomCradlesCase() {
        super("random cradles",
            "rows of 5, 24, 100 and 200 equal balls, with random radii, gaps, places and speeds, to all four sides. "
            + "There are as many impacts as gaps; the last ball flies off with the speed of the first, the others "
            + "rest, exactly. On every event rung, one by one and as a crowd; touching rows of 26 with any equal "
            + "masses too, counted on official");
    }

    @Override
    public Finding run(Rung rung, RunLength size) {
        StringBuilder text = new StringBuilder();
        boolean met = true;
        SplitMix64 random = new SplitMix64(SEED);
        Advance[] advances = {rung.advance(ImpactLaw.PHYSICS), rung.crowdAdvance(ImpactLaw.PHYSICS)};
        for (int length : LENGTHS) {
            int rows = size.pick(length < 100 ? 200 : 5, length < 100 ? 5_000 : 100, length < 100 ? 100_000 : 2_000);
            int right = 0;
            long most = 0;
            for (int n = 0; n < rows; n++) {
                Bodies bodies = row(random, length);
                boolean fine = true;
                for (Advance advance : advances) {
                    Bodies copy = bodies.copy();
                    Probe probe = new Probe();
                    advance.turn(copy, probe);
                    most = Math.max(most, probe.impacts);
                    fine &= probe.impacts == length - 1 && hasPassedOn(bodies, copy);
                }
                right += fine ? 1 : 0;
            }
            met &= right == rows;
            text.append(text.length() == 0 ? "" : "; ").append(String.format(Locale.ROOT,
                "%d balls: %d of %d right, at most %d impacts", length, right, rows, most));
        }
        int rows = size.pick(200, 2_000, 20_000);
        int right = 0;
        long most = 0;
        for (int n = 0; n < rows; n++) {
            Bodies bodies = touching(random);
            Bodies copy = bodies.copy();
            Probe probe = new Probe();
            advances[0].turn(copy, probe);
            most = Math.max(most, probe.impacts);
            right += probe.impacts == TOUCHING - 1 && isPassedOn(bodies, copy) ? 1 : 0;
        }
        text.append(String.format(Locale.ROOT, "; %d touching balls of any mass: %d of %d right, at most %d impacts",
            TOUCHING, right, rows, most));
        return Finding.of(rung.isEvent(), met && (right == rows || rung.arithmetic().isOfficial()), text.toString());
    }

    /** Along x, in contact but for rounding; mass and inverse mass are off from each other by a rounding. */
    private static Bodies touching(SplitMix64 random) {
        double mass = 0.1 + 10 * random.nextDouble();
        double radius = 0.01 + 100 * random.nextDouble();
        double place = random.nextInt(2) * 1000 * (random.nextDouble() - 0.5);
        Bodies bodies = new Bodies(TOUCHING);
        for (int k = 0; k < TOUCHING; k++) {
            bodies.add(place + 2 * radius * k - (k == 0 ? radius : 0), 0, radius, mass);
        }
        bodies.setVelocity(0, 3 * radius, 0);
        return bodies;
    }

    /** True if the last has the velocity of the first, but for rounding, and the others rest but for as much. */
    private static boolean isPassedOn(Bodies before, Bodies after) {
        int last = before.size() - 1;
        return IntStream.rangeClosed(0, last).allMatch(k ->
            Math.abs(after.vx[k] - (k == last ? before.vx[0] : 0)) <= ROUNDING * before.vx[0]);
    }

    /** The first has crossed all gaps, and the last flies, before three quarters of the turn. */
    private static Bodies row(SplitMix64 random, int length) {
        double radius = StrictMath.pow(10, 6 * random.nextDouble() - 2);
        double gaps = random.nextInt(3) == 0 ? 0 : radius * StrictMath.pow(10, -random.nextInt(17)) / length;
        boolean alongX = random.nextInt(2) == 0;
        int side = random.nextInt(2) == 0 ? 1 : -1;
        double across = radius * 100 * (random.nextDouble() - 0.5);
        double place = side * radius * 10 * random.nextDouble();
        double start = radius * (0.1 + random.nextDouble());
        Bodies bodies = new Bodies(length);
        for (int k = 0; k < length; k++) {
            bodies.add(alongX ? place : across, alongX ? across : place, radius, 1);
            place += side * (2 * radius + (k == 0 ? start : gaps * random.nextDouble()));
        }
        double speed = side * (start + 2 * radius * length * 0x1p-40 + gaps * length) * (1.4 + random.nextDouble());
        bodies.setVelocity(0, alongX ? speed : 0, alongX ? 0 : speed);
        return bodies;
    }

    private static boolean hasPassedOn(Bodies before, Bodies after) {
        int last = before.size() - 1;
        return IntStream.rangeClosed(0, last).allMatch(k -> after.vx[k] == (k == last ? before.vx[0] : 0)
            && after.vy[k] == (k == last ? before.vy[0] : 0));
    }
}
