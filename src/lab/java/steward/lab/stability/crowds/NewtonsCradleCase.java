package steward.lab.stability.crowds;

import java.util.stream.IntStream;
import steward.lab.trial.Finding;
import steward.lab.trial.Probe;
import steward.lab.trial.Progress;
import steward.lab.trial.RunLength;
import steward.lab.trial.Rung;
import steward.lab.trial.StabilityCase;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;

/** Stability case of Newton's cradle of five: four at rest in a row, in contact or nearly, hit by the fifth. */
public final class NewtonsCradleCase extends StabilityCase {

    private static final int BALLS = 5;
    /** A power of two, small enough that gaps of 1e-15 can be stored beside it. */
    private static final double RADIUS = 0x1p-10;

    public NewtonsCradleCase() {
        super("Newton's cradle",
            "5 balls with gaps 0, 1e-15, 1e-12: 4 impacts, the last flies off with the speed of the first, the "
            + "others rest, exactly, on every event rung");
    }

    @Override
    public Finding run(Rung rung, RunLength size, Progress progress) {
        StringBuilder text = new StringBuilder();
        boolean met = true;
        for (double gap : new double[] {0, 1e-15, 1e-12}) {
            for (double speed : new double[] {1, 1.0 / 3, -0.7}) {
                Bodies bodies = row(gap, speed);
                Probe probe = new Probe();
                rung.advance(ImpactLaw.PHYSICS).turn(bodies, probe);
                boolean right = probe.impacts == BALLS - 1 && speeds(bodies, speed);
                met &= right;
                if (!right) {
                    text.append("; gap ").append(gap).append(": ").append(probe.impacts).append(" impacts");
                }
            }
        }
        return Finding.of(rung.isEvent(), met, met ? "exact with each gap and speed" : text.substring(2));
    }

    /** The fifth comes from the left, or for a negative speed from the right. */
    private static Bodies row(double gap, double speed) {
        Bodies bodies = new Bodies(BALLS);
        double step = 2 * RADIUS + gap;
        int comes = speed > 0 ? 0 : BALLS - 1;
        for (int k = 0; k < BALLS; k++) {
            bodies.add(k * step - (k == comes ? Math.signum(speed) / 16 : 0), 0, RADIUS, 1);
        }
        bodies.setVelocity(comes, speed, 0);
        return bodies;
    }

    private static boolean speeds(Bodies bodies, double speed) {
        int leaves = speed > 0 ? BALLS - 1 : 0;
        return IntStream.range(0, BALLS).allMatch(k -> bodies.vx[k] == (k == leaves ? speed : 0) && bodies.vy[k] == 0);
    }
}
