package steward.lab.stability.crowds;

import steward.lab.trial.Finding;
import steward.lab.trial.Probe;
import steward.lab.trial.RunLength;
import steward.lab.trial.Rung;
import steward.lab.trial.StabilityCase;
import steward.numerics.SplitMix64;
import steward.physics.Bodies;
import steward.physics.HalfPlane;
import steward.physics.ImpactLaw;
import steward.physics.Wall;

/**
 * Stability case of mirror symmetry: one body hits two touching ones, or a small world among walls, compared with its
 * mirror image.
 */
public final class MirrorCase extends StabilityCase {

    private static final long SEED = 11;
    private static final double SIDE = 700;

    public MirrorCase() {
        super("mirror images",
            "mirrored positions with the same ids give mirrored outputs, bit for bit, on every rung; there are "
            + "impacts");
    }

    @Override
    public Finding run(Rung rung, RunLength size) {
        int wrong = 0;
        int worlds = 0;
        Probe probe = new Probe();
        for (double speed : new double[] {100, 171.3, 5000}) {
            Bodies trio = trio(speed);
            for (int mirror = 1; mirror < 4; mirror++) {
                worlds++;
                wrong += agrees(rung, trio, mirror, 3, probe) ? 0 : 1;
            }
        }
        for (int n = 0; n < size.pick(300, 3000, 30_000); n++) {
            Bodies gas = gas(new SplitMix64(SEED + n));
            worlds++;
            wrong += agrees(rung, gas, 1 + n % 3, 4, probe) ? 0 : 1;
        }
        return Finding.demanded(wrong == 0 && probe.impacts > worlds,
            worlds + " worlds, " + probe.impacts + " impacts, " + wrong + " not mirrored");
    }

    /** Two that touch, one above the other, and a third that hits between them. */
    private static Bodies trio(double speed) {
        Bodies bodies = new Bodies(3);
        bodies.add(-50, 0, 10, 1);
        bodies.add(0, 10, 10, 1);
        bodies.add(0, -10, 10, 1);
        bodies.setVelocity(0, speed, 0);
        return bodies;
    }

    private static Bodies gas(SplitMix64 random) {
        Bodies bodies = new Bodies(9);
        for (int k = 0; k < 9; k++) {
            bodies.add(230 * (k % 3 - 1) + 60 * random.nextDouble(), 230 * (k / 3 - 1) + 60 * random.nextDouble(),
                50 + 20 * random.nextDouble(), 1 + random.nextInt(4));
            bodies.setVelocity(k, 800 * (random.nextDouble() - 0.5), 800 * (random.nextDouble() - 0.5));
        }
        return bodies;
    }

    /** @param mirror bit 0: x is negated, bit 1: y is negated */
    private static boolean agrees(Rung rung, Bodies start, int mirror, int turns, Probe probe) {
        double mx = (mirror & 1) == 0 ? 1 : -1;
        double my = (mirror & 2) == 0 ? 1 : -1;
        Bodies one = copy(start, 1, 1);
        Bodies other = copy(start, mx, my);
        var advance = rung.advance(ImpactLaw.PHYSICS, walls(1, 1));
        var mirrored = rung.advance(ImpactLaw.PHYSICS, walls(mx, my));
        for (int turn = 0; turn < turns; turn++) {
            advance.turn(one, probe);
            mirrored.turn(other, new Probe());
        }
        return Probe.same(one, copy(other, mx, my));
    }

    /** Around the origin, in the same order in the mirror image. */
    private static Wall[] walls(double mx, double my) {
        return new Wall[] {
            new HalfPlane(-SIDE * mx, 0, mx, 0, 1), new HalfPlane(0, -SIDE * my, 0, my, 1),
            new HalfPlane(SIDE * mx, 0, -mx, 0, 1), new HalfPlane(0, SIDE * my, 0, -my, 1)};
    }

    private static Bodies copy(Bodies from, double mx, double my) {
        Bodies bodies = from.copy();
        for (int k = 0; k < from.size(); k++) {
            bodies.setPosition(k, mx * from.x[k], my * from.y[k]);
            bodies.setVelocity(k, mx * from.vx[k], my * from.vy[k]);
        }
        return bodies;
    }
}
