package steward.lab.stability.bodies;

import java.util.Locale;
import steward.lab.trial.Finding;
import steward.lab.trial.RunLength;
import steward.lab.trial.Rung;
import steward.lab.trial.StabilityCase;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;

/** Stability case of dropped elastic balls: their energy at the ends of turns must stay. */
public final class ElasticFallCase extends StabilityCase {

    private static final double[][] DROPS = {{790, 9.81}, {100, 9.81}, {100, 2}, {2, 9.81}, {33, 0.7}};

    public ElasticFallCase() {
        super("elastic falls", "elastic balls dropped from 2 to 790 u, with gravity a = 0.7 to 9.81, for 200 (quick)"
            + " to 20,000 turns. They return to between their height and a/8 above it, and keep the energy (v + "
            + "a/2)^2 / 2 + a h to 1e-9. On event rungs of ours");
    }

    @Override
    public Finding run(Rung rung, RunLength size) {
        int turns = size.pick(200, 5_000, 20_000);
        double above = Double.NEGATIVE_INFINITY;
        double below = Double.NEGATIVE_INFINITY;
        double drift = 0;
        for (double[] drop : DROPS) {
            double a = drop[1];
            Bodies bodies = new Bodies(1);
            Falls.add(bodies, 0, -10 - drop[0], 1, 1);
            Falls falls = new Falls(bodies, rung, false, ImpactLaw.PHYSICS, a, Falls.FLOOR);
            double energy = a * a / 8 + a * drop[0];
            double highest = 0;
            double peak = drop[0];
            for (int turn = 0; turn < turns; turn++) {
                double before = bodies.vy[0];
                falls.turn();
                double height = -10 - bodies.y[0];
                double v = bodies.vy[0] + a / 2;
                drift = Math.max(drift, Math.abs((v * v / 2 + a * height) / energy - 1));
                peak = Math.max(peak, height);
                if (before > 0 && bodies.vy[0] <= 0) {
                    above = Math.max(above, (peak - drop[0]) / a);
                    below = Math.max(below, highest > 0 ? (drop[0] - peak) / a : below);
                    highest = peak;
                    peak = 0;
                }
            }
        }
        boolean met = above <= 0.125 + 1e-9 && below <= 1e-9 && drift <= 1e-9;
        return Finding.of(rung.isOurs(), met, String.format(Locale.ROOT, "%d turns each: peaks at most %.4f a above "
            + "and %.1e a below, energy off by %.1e", turns, above, Math.max(0, below), drift));
    }
}
