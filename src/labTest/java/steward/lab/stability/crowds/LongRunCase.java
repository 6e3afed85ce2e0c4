package steward.lab.stability.crowds;

import java.math.BigDecimal;
import java.util.Locale;
import steward.lab.trial.Finding;
import steward.lab.trial.MomentumBalance;
import steward.lab.trial.Probe;
import steward.lab.trial.RunLength;
import steward.lab.trial.Rung;
import steward.lab.trial.StabilityCase;
import steward.numerics.SplitMix64;
import steward.physics.Advance;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;
import steward.physics.Wall;

/**
 * Stability case of many elastic impacts in a box: the drift of the energy, and whether the momentum balance is closed.
 */
public final class LongRunCase extends StabilityCase {

    private static final long SEED = 16;
    private static final double MOMENTUM_GAP = 1e-28;
    private static final long MILLION = 1_000_000;
    /** From this many bodies on, checking all pairs at each impact would take too long. */
    private static final int CROWD = 100;
    /** A turn has one impact or more on average: a rung that needs this many turns for each one misses impacts. */
    private static final int TURNS_PER_IMPACT = 10;

    private final int bodies;
    private final double drift;

    /** @param drift the most that the energy may change, relative to itself, after a million impacts */
    public LongRunCase(int bodies, double drift) {
        super("long run of " + bodies,
            String.format(Locale.ROOT, "energy within %.0e after 10^6 elastic impacts, on every event rung but "
            + "official. The expressions of official are the server's: it rounds 1 / mass, by which all impulses of "
            + "a pair are off to the same side. Momentum between the walls is accounted for to %.0e by "
            + "m (v after - v before), on every event rung", drift, MOMENTUM_GAP));
        this.bodies = bodies;
        this.drift = drift;
    }

    @Override
    public Finding run(Rung rung, RunLength size) {
        int small = bodies == 10 ? 100_000 : 20_000;
        long wanted = rung.isEvent() ? size.pick(small, 1_000_000, 10_000_000) : 1;
        Bodies gas = gas();
        MomentumBalance balance = new MomentumBalance(gas);
        Wall[] box = Wall.box(side(), side(), 1);
        Advance advance = bodies < CROWD ? rung.advance(ImpactLaw.PHYSICS, box)
            : rung.crowdAdvance(ImpactLaw.PHYSICS, box);
        BigDecimal energy = Probe.energy(gas);
        double atMillion = Double.NaN;
        for (long turn = 0; balance.impacts < wanted && turn < TURNS_PER_IMPACT * wanted; turn++) {
            advance.turn(gas, balance);
            if (Double.isNaN(atMillion) && balance.impacts >= MILLION) {
                atMillion = drift(gas, energy);
            }
        }
        double last = drift(gas, energy);
        double judged = Double.isNaN(atMillion) ? last : atMillion;
        double gap = balance.gap(gas);
        boolean met = balance.impacts >= wanted && (judged <= drift || !rung.isOurs()) && gap <= MOMENTUM_GAP;
        return Finding.of(rung.isEvent(), met, String.format(Locale.ROOT, "%d impacts: energy %.1e%s, books %.1e",
            balance.impacts, last, last == judged ? "" : String.format(Locale.ROOT, " (%.1e after 10^6)", judged),
            gap));
    }

    private static double drift(Bodies gas, BigDecimal energy) {
        return Probe.energy(gas).subtract(energy).abs().doubleValue() / energy.doubleValue();
    }

    private double side() {
        return 100 * Math.ceil(Math.sqrt(bodies));
    }

    /** On a grid of 100 u, radius 20, masses 1 to 4. */
    private Bodies gas() {
        SplitMix64 random = new SplitMix64(SEED + bodies);
        Bodies gas = new Bodies(bodies);
        int perRow = (int) Math.ceil(Math.sqrt(bodies));
        double speed = 1000.0 / bodies;                        // at most some ten impacts a turn, whatever the count
        for (int k = 0; k < bodies; k++) {
            gas.add(100 * (k % perRow) + 25 + 50 * random.nextDouble(),
                100 * (k / perRow) + 25 + 50 * random.nextDouble(), 20, 1 + 3 * random.nextDouble());
            gas.setVelocity(k, speed * (random.nextDouble() - 0.5), speed * (random.nextDouble() - 0.5));
        }
        return gas;
    }
}
