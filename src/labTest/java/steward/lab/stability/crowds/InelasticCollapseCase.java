package steward.lab.stability.crowds;

import java.math.BigDecimal;
import java.util.Locale;
import steward.lab.trial.Finding;
import steward.lab.trial.Probe;
import steward.lab.trial.RunLength;
import steward.lab.trial.Rung;
import steward.lab.trial.StabilityCase;
import steward.physics.Advance;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;

/**
 * Stability case of inelastic collapse: infinitely many impacts in a finite time. In one dimension 3 bodies collapse
 * below e = 7 - 4 sqrt 3 = 0.072, and n bodies when n is above about ln(4 / (1 - e)) / (1 - e), 88 for e = 0.95 (S.
 * McNamara and W. R. Young, "Inelastic collapse and clumping in a one-dimensional granular medium", 1992).
 */
public final class InelasticCollapseCase extends StabilityCase {

    /** Without rest, which would end it. */
    private static final ImpactLaw LAW = ImpactLaw.PHYSICS.withRestitution(ImpactLaw.Restitution.MINIMUM)
        .withRestSpeed(0);

    public InelasticCollapseCase() {
        super("inelastic collapse",
            "under a law without rest, e = 0.05 with 3 bodies, e = 0.95 with 90. On every rung each turn ends, by "
            + "itself or named at the bound on impacts (steps have none), and energy never grows. On event rungs "
            + "there are impacts until rounding ends them; a bound of 20 or 500 on them is reached, and named");
    }

    @Override
    public Finding run(Rung rung, RunLength size) {
        int bound = size.pick(5000, 0, 0);
        String text = "3: " + collapse(rung, 3, 0.05, size.pick(20, 100, 1000), bound, false)
            + "; 90: " + collapse(rung, 90, 0.95, size.pick(2, 20, 200), bound, false)
            + "; bounded, 3: " + collapse(rung, 3, 0.05, 1, 20, true)
            + "; 90: " + collapse(rung, 90, 0.95, 2, 500, true);
        return Finding.demanded(!text.contains("!"), text);
    }

    /** @param mustReach whether the limit is below the number of impacts of a collapse */
    private static String collapse(Rung rung, int count, double restitution, int turns, int bound,
                                   boolean mustReach) {
        Bodies bodies = new Bodies(count);
        for (int k = 0; k < count; k++) {
            bodies.add(25 * k + 3 * (k % 4), 0, 10, 1);
            bodies.setVelocity(k, 40 * (count / 2 - k) + k % 3, 0);
            bodies.setRestitution(k, restitution);
        }
        Advance advance = rung.advance(LAW.withMaximumImpacts(bound));
        Probe probe = new Probe();
        int unnamed = 0;
        double growth = 0;
        for (int turn = 0; turn < turns; turn++) {
            long before = probe.impacts;
            int limited = probe.limited;
            BigDecimal energy = Probe.energy(bodies);
            advance.turn(bodies, probe);
            int most = bound > 0 ? bound : 10_000 + 1_000 * count;
            boolean named = probe.limited > limited || !rung.isEvent();
            unnamed += probe.impacts - before >= most && !named ? 1 : 0;
            growth = Math.max(growth, Probe.energy(bodies).subtract(energy).doubleValue() / energy.doubleValue());
        }
        boolean collapsed = mustReach ? probe.limited > 0 : probe.impacts > 10 * count;
        String problem = (unnamed > 0 ? " unnamed!" : "") + (rung.isEvent() && !collapsed ? " no collapse!" : "")
            + (Probe.finite(bodies) ? "" : " not finite!")
            + (growth > 0 ? String.format(Locale.ROOT, " energy grew by %.1e!", growth) : "");
        return probe.impacts + " impacts in " + turns + " turns, " + probe.limited + " named" + problem;
    }
}
