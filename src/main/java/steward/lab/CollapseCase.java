package steward.lab;

import java.math.BigDecimal;
import java.util.Locale;
import steward.physics.Advance;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;

/**
 * Inelastic collapse: infinitely many impacts in a finite time. In one dimension 3 bodies collapse below
 * e = 7 - 4 sqrt 3 = 0.072, and n bodies when n is above about ln(4 / (1 - e)) / (1 - e), 88 for e = 0.95
 * (S. McNamara and W. R. Young, "Inelastic collapse and clumping in a one-dimensional granular medium", 1992).
 */
final class CollapseCase implements StabilityCase {

    private static final ImpactLaw LAW = ImpactLaw.PHYSICS.withRestitution(ImpactLaw.Restitution.MINIMUM);

    @Override
    public String name() {
        return "inelastic collapse";
    }

    @Override
    public String demand() {
        return "e = 0.05 with 3 bodies, e = 0.95 with 90: every turn ends, by itself or named at the bound on impacts, "
            + "and energy never grows, on every rung";
    }

    @Override
    public Seen run(Rung rung, Size size) {
        int bound = size.pick(5000, 0, 0);
        String three = collapse(rung, 3, 0.05, size.pick(20, 100, 1000), bound);
        String ninety = collapse(rung, 90, 0.95, size.pick(2, 20, 200), bound);
        boolean met = !(three + ninety).contains("!");
        return Seen.demanded(met, "3: " + three + "; 90: " + ninety);
    }

    private static String collapse(Rung rung, int count, double restitution, int turns, int bound) {
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
            unnamed += probe.impacts - before >= most && probe.limited == limited ? 1 : 0;
            growth = Math.max(growth, Probe.energy(bodies).subtract(energy).doubleValue() / energy.doubleValue());
        }
        String problem = (unnamed > 0 ? " unnamed!" : "") + (Probe.finite(bodies) ? "" : " not finite!")
            + (growth > 0 ? String.format(Locale.ROOT, " energy grew by %.1e!", growth) : "");
        return probe.impacts + " impacts in " + turns + " turns, " + probe.limited + " named" + problem;
    }
}
