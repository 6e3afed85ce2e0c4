package steward.lab.stability.crowds;

import java.util.Locale;
import java.util.stream.IntStream;
import steward.lab.trial.Finding;
import steward.lab.trial.Probe;
import steward.lab.trial.RunLength;
import steward.lab.trial.Rung;
import steward.lab.trial.StabilityCase;
import steward.numerics.SplitMix64;
import steward.physics.Advance;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;

/**
 * Stability case of pairs on a lattice that all meet at the same instant, no body in two of them. Whatever the
 * numbering, each body must end at the same position. Under the official law they react in one batch. One at a time
 * means a scan of all bodies for each impact, so the advance for crowds gets all 10,000 and the other one some hundred.
 */
public final class LatticeCase extends StabilityCase {

    private static final long SEED = 13;
    private static final double CELL = 4000;

    public LatticeCase() {
        super("lattice of pairs",
            "10,000 simultaneous pairs: each has its impact, and the result does not depend on the numbering, bit "
            + "for bit, on every event rung");
    }

    @Override
    public Finding run(Rung rung, RunLength size) {
        int batch = rung.isEvent() ? size.pick(500, 10_000, 10_000) : 500;
        int single = size.pick(60, 300, 2000);
        boolean together = agrees(rung.advance(bounded(ImpactLaw.OFFICIAL_POD_RACE, batch)), batch);
        boolean alone = agrees(rung.advance(bounded(ImpactLaw.PHYSICS, single)), single);
        boolean crowd = agrees(rung.crowdAdvance(bounded(ImpactLaw.PHYSICS, batch)), batch);
        return Finding.of(rung.isEvent(), together && alone && crowd, String.format(Locale.ROOT,
            "%d pairs in a batch %s, %d one at a time %s, %d as a crowd %s", batch, verdict(together), single,
            verdict(alone), batch, verdict(crowd)));
    }

    private static String verdict(boolean agree) {
        return agree ? "agree" : "differ";
    }

    /** A limit on impacts that leaves room for every pair. */
    private static ImpactLaw bounded(ImpactLaw law, int pairs) {
        return law.withMaximumImpacts(2 * pairs);
    }

    private static boolean agrees(Advance advance, int pairs) {
        int[] place = IntStream.range(0, 2 * pairs).toArray();
        Bodies plain = lattice(place);
        SplitMix64 random = new SplitMix64(SEED);
        for (int k = place.length - 1; k > 0; k--) {
            int other = random.nextInt(k + 1);
            int kept = place[k];
            place[k] = place[other];
            place[other] = kept;
        }
        Bodies shuffled = lattice(place);
        Probe probe = new Probe();
        advance.turn(plain, probe);
        advance.turn(shuffled, probe);
        boolean same = probe.impacts == 2L * pairs && probe.limited == 0;
        for (int k = 0; k < place.length; k++) {
            same &= Probe.same(plain, place[k], shuffled, k);
        }
        return same;
    }

    /** Body k is the one at the given place: the left (even) or right (odd) of a pair; pairs meet at t = 1/2. */
    private static Bodies lattice(int[] place) {
        Bodies bodies = new Bodies(place.length);
        int perRow = (int) Math.ceil(Math.sqrt(place.length / 2.0));
        for (int body : place) {
            int pair = body / 2;
            int side = body % 2 == 0 ? -1 : 1;
            int k = bodies.add(CELL * (pair % perRow) + side * 600, CELL * (pair / perRow), 400, 1);
            bodies.setVelocity(k, -side * 400, 0);
        }
        return bodies;
    }
}
