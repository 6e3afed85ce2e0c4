package steward.lab.stability.bodies;

import java.util.Locale;
import steward.lab.trial.Finding;
import steward.lab.trial.OracleTurns;
import steward.lab.trial.Probe;
import steward.lab.trial.RunLength;
import steward.lab.trial.Rung;
import steward.lab.trial.StabilityCase;
import steward.numerics.SplitMix64;
import steward.physics.Arena;
import steward.physics.Bodies;
import steward.physics.TurnLog;
import steward.physics.Wall;

/** Stability case of random piles that fall into a wedge or an arena by their weight. */
public final class FallenPilesCase extends StabilityCase {

    private static final long SEED = 58;
    private static final int TURNS = 600;
    private static final int AFTERWARDS = 20;
    private static final int MOST_IMPACTS = 500;
    private static final double MOST_OVERLAP = 1e-12;
    /** Piles of up to so many discs are compared with the oracle's, in every so many turns. */
    private static final int COMPARED = 20;
    private static final int EVERY = 20;
    private static final int EVERY_IN_ARENA = 120;
    private static final double MOST_OFF = 1e-9;
    private static final double MOST_OFF_IN_ARENA = 0x1p-18;
    private static final double[] RESTITUTIONS = {0, 0.3, 0.6, 0.9};
    private static final double ROOM = 110;
    /** Wedges, the last a narrow one, and an arena. */
    private static final Wall[][] PLACES = {{Falls.slope(35, 1), Falls.slope(40, -1)},
        {Falls.slope(45, 1), Falls.slope(5, -1)},
        {new Arena(0, -ROOM, ROOM, 1)}, {Falls.slope(80, 1), Falls.slope(75, -1)}};

    public FallenPilesCase() {
        super("fallen piles", "random piles of 3 to 60 discs fall into wedges of 35 and 40, 45 and 5, 80 and 75 "
            + "degrees, and up to 20 discs into an arena of radius 110. Gravity is 2, e = 0, 0.3, 0.6, 0.9. They "
            + "lie still (1e-6 u a turn) within 600 turns; in the arena, where they swing, 4 R/a ln(3e6) later. "
            + "Then turns have at most 500 impacts. None overlap by more than 1e-12 of a radius, no turn reaches "
            + "its limit, and one by one and as a crowd are the same to the bit. Every 20th turn of up to 20 discs "
            + "is compared, in the arena every 120th: 19 of 20 are the oracle's to 1e-9 of the speeds. A "
            + "path in the arena ends on the rim to 2^-40 of the room; so there 19 of 20 are to 4 times the root of "
            + "that. On event rungs of ours");
    }

    @Override
    public Finding run(Rung rung, RunLength size) {
        SplitMix64 random = new SplitMix64(SEED);
        int piles = size.pick(4, 8, 64);
        OracleTurns straight = new OracleTurns(MOST_OFF);
        OracleTurns inArena = new OracleTurns(MOST_OFF_IN_ARENA);
        int moving = 0;
        int most = 0;
        int before = 0;
        int limited = 0;
        int different = 0;
        double overlap = 0;
        for (int n = 0; n < piles; n++) {
            Wall[] walls = PLACES[n % PLACES.length];
            boolean round = walls[0] instanceof Arena;
            int count = n == 3 ? 60 : 3 + random.nextInt(round ? 18 : size.pick(15, 58, 58));
            Bodies bodies = bodies(random, count, RESTITUTIONS[(n + n / PLACES.length) % RESTITUTIONS.length], walls);
            Bodies copy = new Bodies(count);
            Falls falls = new Falls(bodies, rung, false, Falls.SOFT, 2, walls);
            if (rung.isEvent() && count <= COMPARED) {
                falls.comparing(round ? inArena : straight, round ? EVERY_IN_ARENA : EVERY);
            }
            Falls crowd = new Falls(copy, rung, true, Falls.SOFT, 2, walls);
            int turns = round ? TURNS + (int) (4 * ROOM / 2 * StrictMath.log(3e6)) : TURNS;
            TurnLog log = new TurnLog();
            int still = 0;
            for (int turn = 1; turn <= turns && still < AFTERWARDS; turn++) {
                copy.copyFrom(bodies);
                int impacts = falls.impacts(log);
                limited += log.limited() ? 1 : 0;
                crowd.turn();
                boolean same = true;
                for (int k = 0; k < count; k++) {
                    same &= Probe.same(bodies, k, copy, k);
                }
                different += same ? 0 : 1;
                before = Math.max(before, impacts);
                most = still > 0 ? Math.max(most, impacts) : most;
                still = falls.fastest() < Falls.STILL ? still + 1 : 0;
            }
            moving += still < AFTERWARDS ? 1 : 0;
            overlap = Math.max(overlap, overlap(bodies, walls));
        }
        boolean met = moving == 0 && most <= MOST_IMPACTS && limited == 0 && different == 0 && overlap <= MOST_OVERLAP
            && straight.areTrue() && inArena.areTrue();
        return Finding.of(rung.isOurs(), met, String.format(Locale.ROOT, "%d piles, %d never still: at most %d impacts "
            + "in a turn, %d at rest, %d limited, overlap %.1e of a radius, %d turns differ as a crowd; %s; in "
            + "the arena %s", piles, moving, before, most, limited, overlap, different, straight.text(),
            inArena.text()));
    }

    private static Bodies bodies(SplitMix64 random, int count, double restitution, Wall... walls) {
        Bodies bodies = new Bodies(count);
        double height = 60;
        while (bodies.size() < count) {
            height += 0.3;
            double radius = 5 + 9 * random.nextDouble();
            int k = bodies.add(-86 + 172 * random.nextDouble(), -height * random.nextDouble()
                - (walls[0] instanceof Arena ? 10 : 90), 1.01 * radius, radius * radius / 50);
            if (overlap(bodies, walls) > 0) {
                bodies.remove(k);
                continue;
            }
            bodies.setRadius(k, radius);
            bodies.setRestitution(k, restitution);
        }
        return bodies;
    }

    /** The deepest overlap, as a share of a radius. */
    private static double overlap(Bodies bodies, Wall... walls) {
        double deepest = 0;
        for (int i = 0; i < bodies.size(); i++) {
            for (int j = 0; j < i; j++) {
                double dx = bodies.x[i] - bodies.x[j];
                double dy = bodies.y[i] - bodies.y[j];
                deepest = Math.max(deepest,
                    (bodies.radius[i] + bodies.radius[j] - Math.sqrt(dx * dx + dy * dy)) / bodies.radius[i]);
            }
            for (Wall wall : walls) {
                deepest = Math.max(deepest, -wall.gap(bodies.x[i], bodies.y[i], bodies.radius[i]) / bodies.radius[i]);
            }
        }
        return deepest;
    }
}
