package steward.lab.stability.crowds;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import steward.lab.trial.Finding;
import steward.lab.trial.Probe;
import steward.lab.trial.RunLength;
import steward.lab.trial.Rung;
import steward.lab.trial.StabilityCase;
import steward.numerics.SplitMix64;
import steward.physics.Advance;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;
import steward.physics.Wall;

/*
 *      | o o o o  |      rows of discs of radius 1 at distances of 2 (1 + gap), every other row shifted by half of
 *      |  o o o o |      that: gap 0 is the densest packing of the plane and covers pi / (2 sqrt 3) = 0.9069 of it,
 *      | o o o o  |      a larger gap covers 1 / (1 + gap)^2 of that
 */

/**
 * Stability case of discs so close that there is hardly room to move, in a box that fits. Coverage goes from 0.84 to
 * the densest packing, down to gaps of a few units in the last place. Speeds are proportional to the gap, so that a
 * turn has some impacts per disc; in one world they are not, so that no turn can have all of its impacts.
 */
public final class DensePackingCase extends StabilityCase {

    private static final long SEED = 18;
    private static final double DENSEST = Math.PI / (2 * Math.sqrt(3));
    private static final int ROWS = 6;
    /**
     * Units in the last place of the box's length. Every impact rounds the position of every disc, by half a unit at
     * most; with some hundred impacts between two impacts of the same pair, their distance drifts by sqrt(100) 0.4 of a
     * unit, and this is four times that.
     */
    private static final double OVERLAP_ULPS = 16;
    /** Ten times what the official expressions lose in two million impacts. */
    private static final double ENERGY = 1e-12;
    /** From this gap on all rungs must have the same first impacts; below it, rounding decides the order of impacts. */
    private static final double CLEAR_GAP = 1e-6;
    private static final int COMPARED = 20;

    public DensePackingCase() {
        super("dense packing",
            String.format(Locale.ROOT, "coverage 0.84 to %.4f. No overlap grows above %.0f ulp of the box, no body "
            + "leaves it, the energy is within %.0e, and every turn ends or is named. The first %d impacts are those "
            + "of exact for gaps from %.0e of a radius. On every event rung", DENSEST, OVERLAP_ULPS, ENERGY, COMPARED,
            CLEAR_GAP));
    }

    @Override
    public Finding run(Rung rung, RunLength size) {
        double widest = Math.sqrt(DENSEST / 0.84) - 1;
        Tally tally = new Tally();
        for (double gap : new double[] {widest, 1e-2, 1e-3, 1e-6, 1e-9, 1e-12, 1e-14, 0}) {
            play(rung, gap, Math.max(gap, 1e-15), size.pick(2, 10, 100), 0, tally);
        }
        play(rung, 1e-12, 1, size.pick(2, 10, 100), 2000, tally);
        boolean met = tally.overlap <= OVERLAP_ULPS && tally.energy <= ENERGY && tally.unnamed == 0
            && tally.different.isEmpty() && tally.finite;
        return Finding.of(rung.isEvent(), met, tally.text());
    }

    /** The worst values of all worlds. */
    private static final class Tally {
        private long impacts;
        private int named;
        private int unnamed;
        private double overlap;
        private double energy;
        private boolean finite = true;
        private String different = "";

        String text() {
            return String.format(Locale.ROOT, "%d impacts, overlap %.2g ulp, energy %.1e, %d turns named%s%s%s",
                impacts, overlap, energy, named, unnamed > 0 ? ", " + unnamed + " not" : "",
                finite ? "" : ", not finite", different.isEmpty() ? "" : ", other impacts at gaps" + different);
        }
    }

    private static void play(Rung rung, double gap, double speed, int turns, int bound, Tally tally) {
        Bodies discs = discs(gap, speed);
        double width = (2 * ROWS + 1) * (1 + gap);
        double height = (ROWS - 1) * Math.sqrt(3) * (1 + gap) + 2 * (1 + gap);
        Wall[] box = Wall.box(width, height, 1);
        ImpactLaw law = ImpactLaw.PHYSICS.withMaximumImpacts(bound);
        if (gap >= CLEAR_GAP && rung.isEvent()
            && !first(rung, law, discs, box).equals(first(exact(), law, discs, box))) {
            tally.different += " " + gap;
        }
        Advance advance = rung.advance(law, box);
        BigDecimal energy = Probe.energy(discs);
        double before = overlap(discs, width, height);
        Probe probe = new Probe();
        for (int turn = 0; turn < turns; turn++) {
            long impacts = probe.impacts;
            int named = probe.limited;
            advance.turn(discs, probe);
            boolean full = probe.impacts - impacts >= law.impactLimit(discs.size());
            tally.unnamed += full && rung.isEvent() && probe.limited == named ? 1 : 0;
            tally.overlap = Math.max(tally.overlap,
                (overlap(discs, width, height) - Math.max(0, before)) / Math.ulp(width));
        }
        tally.impacts += probe.impacts;
        tally.named += probe.limited;
        tally.finite &= Probe.finite(discs);
        tally.energy = Math.max(tally.energy,
            Probe.energy(discs).subtract(energy).abs().doubleValue() / energy.doubleValue());
    }

    private static Rung exact() {
        return Rung.all().stream().filter(Rung::isExact).findFirst().orElseThrow();
    }

    /** The bodies of the first impacts, in order. */
    private static List<Integer> first(Rung rung, ImpactLaw law, Bodies start, Wall[] box) {
        Bodies discs = start.copy();
        List<Integer> pairs = new ArrayList<>();
        rung.advance(law, box).turn(discs, new Probe() {
            @Override
            public void touched(int a, int b, double ax, double ay, double bx, double by) {
                if (pairs.size() < 2 * COMPARED) {
                    pairs.add(a);
                    pairs.add(b);
                }
            }
        });
        return pairs;
    }

    /** The deepest overlap of all pairs and walls; below 0 if nothing touches. */
    private static double overlap(Bodies discs, double width, double height) {
        double deepest = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < discs.size(); i++) {
            double x = discs.x[i];
            double y = discs.y[i];
            double free = Math.min(Math.min(x, width - x), Math.min(y, height - y));
            deepest = Math.max(deepest, 1 - free);
            for (int j = 0; j < i; j++) {
                deepest = Math.max(deepest, 2 - Math.hypot(x - discs.x[j], y - discs.y[j]));
            }
        }
        return deepest;
    }

    private static Bodies discs(double gap, double speed) {
        SplitMix64 random = new SplitMix64(SEED);
        Bodies discs = new Bodies(ROWS * ROWS);
        double reach = 1 + gap;
        for (int k = 0; k < ROWS * ROWS; k++) {
            int row = k / ROWS;
            double aside = 0.3 * gap;
            discs.add(reach * (1 + 2 * (k % ROWS) + row % 2) + aside * (random.nextDouble() - 0.5),
                reach * (1 + Math.sqrt(3) * row) + aside * (random.nextDouble() - 0.5), 1, 1 + random.nextDouble());
            discs.setVelocity(k, 4 * speed * (random.nextDouble() - 0.5), 4 * speed * (random.nextDouble() - 0.5));
        }
        return discs;
    }
}
