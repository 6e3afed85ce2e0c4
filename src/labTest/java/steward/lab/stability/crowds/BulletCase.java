package steward.lab.stability.crowds;

import java.util.Arrays;
import steward.lab.trial.Finding;
import steward.lab.trial.Probe;
import steward.lab.trial.RunLength;
import steward.lab.trial.Rung;
import steward.lab.trial.StabilityCase;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;

/**
 * Stability case of a heavy bullet: a body of mass 1e30 flies at 1e8 u per turn past a row of 1,000 bodies. Their
 * centres are 15 u above and below its path in turn: it touches each (10 + 10 u) and pushes it out of the row, away
 * from the next.
 */
public final class BulletCase extends StabilityCase {

    private static final double MASS = 1e30;
    private static final double SPACING = 9e4;

    public BulletCase() {
        super("bullet", "1e8 u per turn through a row of 1,000: every hit counted, once, on every event rung");
    }

    @Override
    public Finding run(Rung rung, RunLength size) {
        int row = size.pick(200, 1000, 1000);
        Bodies bodies = new Bodies(row + 1);
        bodies.add(0, 0, 10, MASS);
        bodies.setVelocity(0, 1e8, 0);
        for (int k = 1; k <= row; k++) {
            bodies.add(k * SPACING, k % 2 == 0 ? 15 : -15, 10, 1);
        }
        int[] hits = new int[row + 1];
        Probe probe = new Probe() {
            @Override
            public void touched(int a, int b, double ax, double ay, double bx, double by) {
                hits[Math.max(a, b)] += Math.min(a, b) == 0 ? 1 : 1000;
            }
        };
        rung.advance(ImpactLaw.PHYSICS).turn(bodies, probe);
        long once = Arrays.stream(hits).filter(count -> count == 1).count();
        return Finding.of(rung.isEvent(), once == row && probe.impacts == row && Probe.finite(bodies),
            probe.impacts + " impacts, " + once + " of " + row + " hit once");
    }
}
