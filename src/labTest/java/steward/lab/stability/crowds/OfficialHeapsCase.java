package steward.lab.stability.crowds;

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

/**
 * Stability case of four pods in the space of one to four, under the official law: the minimum impulse drives them
 * apart.
 */
public final class OfficialHeapsCase extends StabilityCase {

    private static final long SEED = 14;

    public OfficialHeapsCase() {
        super("four dense pods",
            "official rules, 8 million random states: no NaN, no turn at the bound on impacts, on every event rung; "
            + "the most impacts in a turn is reported");
    }

    @Override
    public Finding run(Rung rung, RunLength size) {
        boolean official = rung.arithmetic().isOfficial();
        int states = size.pick(20_000, official ? 8_000_000 : 1_000_000, 8_000_000);
        Advance advance = rung.advance(ImpactLaw.OFFICIAL_POD_RACE);
        SplitMix64 random = new SplitMix64(SEED);
        Heaps seen = new Heaps();
        Bodies bodies = new Bodies(4);
        for (int n = 0; n < states; n++) {
            heap(random, bodies, n);
            long before = seen.impacts;
            advance.turn(bodies, seen);
            seen.states++;
            seen.notFinite += Probe.finite(bodies) ? 0 : 1;
            seen.most = Math.max(seen.most, seen.impacts - before);
        }
        boolean met = seen.notFinite == 0 && seen.limited == 0 && seen.impacts > states;
        return Finding.of(rung.isEvent(), met, seen.text());
    }

    /** Sums up the results of the states. */
    private static final class Heaps extends Probe {

        private long states;
        private long most;
        private long notFinite;

        String text() {
            return String.format(Locale.ROOT, "%d states, %d impacts, at most %d in a turn, %d at the bound, %d not "
                + "finite", states, impacts, most, limited, notFinite);
        }
    }

    /** A quarter has integer coordinates, a quarter of the pods is shielded, speeds are 0, ordinary or extreme. */
    private static void heap(SplitMix64 random, Bodies bodies, int n) {
        while (bodies.size() > 0) {
            bodies.remove(bodies.size() - 1);
        }
        double side = switch (n % 6) {
            case 0 -> 100 * random.nextDouble();
            case 1, 2 -> 400 + 800 * random.nextDouble();
            default -> 1000 + 2000 * random.nextDouble();
        };
        double speed = n % 5 == 0 ? 0 : n % 5 == 1 ? 6000 : 1200;
        boolean whole = n % 4 == 0;
        for (int k = 0; k < 4; k++) {
            double x = side * random.nextDouble();
            double y = side * random.nextDouble();
            bodies.add(whole ? Math.rint(x) : x, whole ? Math.rint(y) : y, 400, random.nextInt(4) == 0 ? 10 : 1);
            bodies.setVelocity(k, speed * (2 * random.nextDouble() - 1), speed * (2 * random.nextDouble() - 1));
        }
    }
}
