package steward.lab.stability.crowds;

import java.util.Locale;
import steward.lab.trial.Finding;
import steward.lab.trial.Probe;
import steward.lab.trial.RunLength;
import steward.lab.trial.Rung;
import steward.lab.trial.StabilityCase;
import steward.numerics.SplitMix64;
import steward.physics.Advance;
import steward.physics.Bodies;
import steward.physics.Impact;
import steward.physics.ImpactLaw;
import steward.physics.TurnLog;
import steward.physics.Wall;

/**
 * Stability case of simultaneous impacts: bodies on a lattice with a few different velocities, some at rest, some
 * touching. So many impacts have the same instant, also several of one body. One by one and as a crowd, the same pairs
 * must meet in the same order, and everything must be the same to the bit.
 */
public final class TiesCase extends StabilityCase {

    private static final long SEED = 16;
    private static final ImpactLaw SOFT = ImpactLaw.PHYSICS.withRestitution(ImpactLaw.Restitution.MINIMUM);

    public TiesCase() {
        super("ties",
            "worlds of 24 to 53 bodies on a lattice, with impacts of one body at one instant. One by one and as a "
            + "crowd there are as many impacts, in the same order, with the same bits. On every event rung");
    }

    @Override
    public Finding run(Rung rung, RunLength size) {
        int worlds = size.pick(300, 3_000, 100_000);
        SplitMix64 random = new SplitMix64(SEED);
        int number = 0;
        int order = 0;
        int bits = 0;
        long impacts = 0;
        TurnLog one = new TurnLog();
        TurnLog other = new TurnLog();
        for (int n = 0; n < worlds; n++) {
            Wall[] walls = random.nextInt(2) == 0 ? Wall.box(640, 640, 1) : new Wall[0];
            Bodies bodies = world(random);
            Bodies copy = bodies.copy();
            ImpactLaw law = random.nextInt(3) == 0 ? SOFT : ImpactLaw.PHYSICS;
            play(rung.advance(law, walls), bodies, one);
            play(rung.crowdAdvance(law, walls), copy, other);
            impacts += one.impacts();
            number += one.impacts() != other.impacts() ? 1 : 0;
            order += sameOrder(one, other) ? 0 : 1;
            bits += Probe.finite(bodies) && Probe.same(bodies, copy) ? 0 : 1;
        }
        return Finding.of(rung.isEvent(), number == 0 && order == 0 && bits == 0 && impacts > worlds,
            String.format(Locale.ROOT,
            "%d worlds, %d impacts: %d worlds differ in number, %d in order, %d in bits", worlds, impacts, number,
            order, bits));
    }

    private static void play(Advance advance, Bodies bodies, TurnLog log) {
        log.clear();
        advance.turn(bodies, log);
    }

    private static boolean sameOrder(TurnLog one, TurnLog other) {
        int count = Math.min(one.impacts(), other.impacts());
        for (int k = 0; k < count; k++) {
            Impact i = one.impact(k);
            Impact j = other.impact(k);
            if (i.a() != j.a() || i.b() != j.b()) {
                return false;
            }
        }
        return one.impacts() == other.impacts();
    }

    /** Radius 10 on a lattice with 20, 24, 32, 40 or 64 between its points: also exactly touching, or 1 apart. */
    private static Bodies world(SplitMix64 random) {
        int count = 24 + random.nextInt(30);
        int step = new int[] {20, 24, 32, 40, 64}[random.nextInt(5)];
        int unit = new int[] {8, 10, 16, 30}[random.nextInt(4)];
        int side = 8;
        boolean[] taken = new boolean[side * side];
        Bodies bodies = new Bodies(count);
        for (int k = 0; k < count; k++) {
            int point = random.nextInt(side * side);
            while (taken[point]) {
                point = (point + 1) % (side * side);
            }
            taken[point] = true;
            bodies.add(64 + step * (point % side), 64 + step * (point / side), 10, 1);
            bodies.setVelocity(k, speed(random, unit), speed(random, unit));
            bodies.setRestitution(k, 0.5 + 0.5 * random.nextDouble());
        }
        return bodies;
    }

    private static double speed(SplitMix64 random, int unit) {
        int times = random.nextInt(9) - 4;
        return times == 0 && random.nextInt(2) == 0 ? -0.0 : unit * times;
    }
}
