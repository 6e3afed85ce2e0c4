package steward.lab.stability.pairs;

import java.math.BigDecimal;
import java.util.Locale;
import steward.lab.oracle.Decimals;
import steward.lab.trial.Finding;
import steward.lab.trial.Probe;
import steward.lab.trial.RunLength;
import steward.lab.trial.Rung;
import steward.lab.trial.StabilityCase;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;

/**
 * Stability case of impacts that follow each other by 1e-9 turns at the very end of a turn. A body hits a row whose
 * gaps it crosses in that time. There is no clock across turns ({@link steward.physics.Advance} does not know the
 * turn's number), so a late turn of a match is like any other. Within a turn, rounding a time near 1 moves a body by
 * 1e-16 of its speed.
 */
public final class LateTimesCase extends StabilityCase {

    private static final int ROW = 5;
    private static final double RADIUS = 10;
    private static final double BETWEEN = 1e-9;
    /** Units in the last place of the position. */
    private static final double MOST_ULPS = 4;

    public LateTimesCase() {
        super("late times",
            "impacts 1e-9 turns apart at the end of a turn, speeds 1..1e8: no overlap above 4 ulp of the position "
            + "when they touch, on every event rung whose expressions are ours");
    }

    @Override
    public Finding run(Rung rung, RunLength size) {
        StringBuilder text = new StringBuilder("overlap in ulp at speed");
        boolean met = true;
        for (double speed = 1; speed <= 1e8; speed *= 100) {
            double worst = 0;
            boolean all = true;
            for (int n = 0; n < size.pick(200, 2000, 20_000); n++) {
                Bodies bodies = row(speed, n);
                Deepest deepest = new Deepest();
                rung.advance(ImpactLaw.PHYSICS).turn(bodies, deepest);
                worst = Math.max(worst, deepest.ulps);
                all &= deepest.impacts == ROW - 1;
            }
            met &= all && worst <= MOST_ULPS;
            text.append(String.format(Locale.ROOT, " %.0e: %.3g%s;", speed, worst, all ? "" : " (impacts missing)"));
        }
        text.setLength(text.length() - 1);
        return Finding.of(rung.isOurs(), met, text.toString());
    }

    /**
     * So far from the origin that all coordinates on the path have the same exponent; the first impact comes 5 to 6
     * times 1e-9 before the end of the turn.
     */
    private static Bodies row(double speed, int n) {
        Bodies bodies = new Bodies(ROW);
        double late = 1 - BETWEEN * (5 + n / 20_000.0);
        double x = 1000 + n / 7.0 + 2 * speed;
        bodies.add(x - speed * late - 2 * RADIUS, 0, RADIUS, 1);
        bodies.setVelocity(0, speed, 0);
        for (int k = 1; k < ROW; k++) {
            bodies.add(x, 0, RADIUS, 1);
            x += 2 * RADIUS + speed * BETWEEN;
        }
        return bodies;
    }

    /** Measures the overlap of touching bodies. */
    private static final class Deepest extends Probe {

        private double ulps;

        @Override
        public void touched(int a, int b, double ax, double ay, double bx, double by) {
            BigDecimal distance = Decimals.length(Decimals.of(bx).subtract(Decimals.of(ax)),
                Decimals.of(by).subtract(Decimals.of(ay)));
            double overlap = Decimals.of(2 * RADIUS).subtract(distance).doubleValue();
            ulps = Math.max(ulps, overlap / Math.ulp(Math.max(Math.abs(ax), Math.abs(bx))));
        }
    }
}
