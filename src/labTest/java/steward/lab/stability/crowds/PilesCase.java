package steward.lab.stability.crowds;

import java.util.List;
import java.util.Locale;
import steward.lab.trial.Finding;
import steward.lab.trial.OracleTurns;
import steward.lab.trial.Probe;
import steward.lab.trial.RunLength;
import steward.lab.trial.Rung;
import steward.lab.trial.StabilityCase;
import steward.numerics.SplitMix64;
import steward.physics.Advance;
import steward.physics.Arena;
import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.HalfPlane;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.TurnLog;
import steward.physics.Wall;

/**
 * Stability case of random piles of 3 to 60 bodies that are pressed together. They are pressed into corners, wedges of
 * 8 to 60 degrees or the rim of an arena, or against each other in free space.
 */
public final class PilesCase extends StabilityCase {

    private static final long SEED = 32;
    private static final int TURNS = 6;
    private static final int MOST_IMPACTS = 500;
    private static final double MOST_OVERLAP = 1e-12;
    /** Piles of up to so many bodies are compared with the oracle's. */
    private static final int COMPARED = 20;
    private static final double MOST_OFF = 1e-9;
    /** Here the last digit decides whether a body that slides along one wall comes to the other. */
    private static final double RIGHT = 90;
    private static final double ROOM = 600;
    /** In degrees; 0 for an arena, 360 for free space. */
    private static final double[] OPENINGS = {90, 60, 45, 30, 15, 8, 0, 360};
    private static final double[] RESTITUTIONS = {0.5, 0.9, 0};
    private static final ImpactLaw SOFT = ImpactLaw.PHYSICS.withRestitution(ImpactLaw.Restitution.MINIMUM);

    /** The worst values of all piles. */
    private static final class Tally {
        private final OracleTurns truth = new OracleTurns(MOST_OFF);
        private int most;
        private int limited;
        private int different;
        private double growth;
        private double overlap;
    }

    public PilesCase() {
        super("piles",
            "random piles of 3 to 60 bodies without restitution, pressed anew each turn into corners, wedges of 8 to"
            + " 60 degrees, the rim of an arena, or together in free space. In free space also piles with e = 0.5 "
            + "and 0.9, pressed once. No turn without restitution has more than 500 impacts, and none reaches its "
            + "limit. Energy never grows (but for 1e-15 of it, by rounding), and none overlap by more than 1e-12 of"
            + " a radius. One by one and as a crowd are the same to the bit. On event rungs of ours, the second "
            + "turns of up to 20 bodies are compared, arenas and right angles left out: 19 of 20 are the oracle's "
            + "to 1e-9 of the speeds. All else is demanded on every event rung");
    }

    @Override
    public Finding run(Rung rung, RunLength size) {
        SplitMix64 random = new SplitMix64(SEED);
        Tally tally = new Tally();
        int piles = size.pick(2, 24, 600);
        for (int n = 0; n < piles; n++) {
            for (double opening : OPENINGS) {
                pile(tally, rung, random, n % 4 == 0 && n > 0 ? 60 : 3 + random.nextInt(size.pick(20, 58, 58)), opening,
                    opening == 360 ? RESTITUTIONS[n % RESTITUTIONS.length] : 0);
            }
        }
        boolean met = tally.most > 0 && tally.most <= MOST_IMPACTS && tally.limited == 0 && tally.different == 0
            && tally.growth <= 1e-15 && tally.overlap <= MOST_OVERLAP && (tally.truth.areTrue() || !rung.isOurs());
        return Finding.of(rung.isEvent(), met, String.format(Locale.ROOT, "%d piles: at most %d impacts in a turn, %d "
            + "limited, energy grew by %.1e, overlap %.1e of a radius, %d turns differ as a crowd; %s",
            piles * OPENINGS.length, tally.most, tally.limited, tally.growth, tally.overlap, tally.different,
            tally.truth.text()));
    }

    private static void pile(Tally tally, Rung rung, SplitMix64 random, int count, double opening, double restitution) {
        Wall[] walls = walls(opening, restitution);
        Bodies bodies = bodies(random, count, walls, restitution);
        Bodies copy = new Bodies(count);
        PhysicsParts parts = new PhysicsParts(SOFT, rung.arithmetic(), new Contacts(1), List.of(walls), null, false);
        Advance alone = rung.maker().apply(parts);
        Advance crowd = rung.crowdAdvance(SOFT, walls);
        double speed = 1 + 100 * random.nextDouble() * random.nextDouble();
        for (int turn = 0; turn < TURNS; turn++) {
            for (int k = 0; k < count && (turn == 0 || restitution == 0); k++) {
                double distance = opening == 360 ? StrictMath.hypot(bodies.x[k], bodies.y[k]) + 1e-9 : 1;
                bodies.setVelocity(k, bodies.vx[k] + speed * (opening == 360 ? -bodies.x[k] / distance
                    : 0.1 * random.nextDouble() - 0.05), bodies.vy[k] - speed * (opening == 360
                    ? bodies.y[k] / distance : 1));
            }
            double before = energy(bodies);
            copy.copyFrom(bodies);
            TurnLog log = new TurnLog();
            alone.turn(bodies, log);
            if (turn == 1 && rung.isEvent() && count <= COMPARED && opening > 0 && opening != RIGHT) {
                tally.truth.add(copy, bodies, parts);
            }
            TurnLog other = new TurnLog();
            crowd.turn(copy, other);
            tally.most = restitution == 0 ? Math.max(tally.most, log.impacts()) : tally.most;
            tally.limited += log.limited() ? 1 : 0;
            tally.growth = Math.max(tally.growth, energy(bodies) / before - 1);
            tally.overlap = Math.max(tally.overlap, overlap(bodies, walls));
            boolean same = log.impacts() == other.impacts();
            for (int k = 0; k < count; k++) {
                same &= Probe.same(bodies, k, copy, k);
            }
            tally.different += same ? 0 : 1;
        }
    }

    private static Wall[] walls(double opening, double restitution) {
        if (opening == 0) {
            return new Wall[] {new Arena(0, ROOM, ROOM, restitution)};
        }
        if (opening == 360) {
            return new Wall[0];
        }
        double half = StrictMath.toRadians(opening / 2);
        double cos = StrictMath.cos(half);
        double sin = StrictMath.sin(half);
        return new Wall[] {new HalfPlane(0, 0, cos, sin, restitution), new HalfPlane(0, 0, -cos, sin, restitution)};
    }

    /** Bodies of radius 6 to 14 at random places with room, as near to the origin as chance puts them. */
    private static Bodies bodies(SplitMix64 random, int count, Wall[] walls, double restitution) {
        Bodies bodies = new Bodies(count);
        boolean equal = random.nextInt(2) == 0;
        double size = 40;
        while (bodies.size() < count) {
            size += 0.05;
            double radius = equal ? 10 : 6 + 8 * random.nextDouble();
            double x = size * (2 * random.nextDouble() - 1);
            double y = size * (2 * random.nextDouble() - 1);
            boolean fits = true;
            for (Wall wall : walls) {
                fits &= wall.gap(x, y, radius) > 0;
            }
            for (int j = 0; j < bodies.size() && fits; j++) {
                double dx = x - bodies.x[j];
                double dy = y - bodies.y[j];
                fits = Math.sqrt(dx * dx + dy * dy) > 1.01 * (radius + bodies.radius[j]);
            }
            if (fits) {
                int k = bodies.add(x, y, radius, equal ? 1 : 0.5 + 3 * random.nextDouble());
                bodies.setRestitution(k, restitution);
            }
        }
        return bodies;
    }

    private static double energy(Bodies bodies) {
        double sum = 0;
        for (int k = 0; k < bodies.size(); k++) {
            sum += bodies.mass[k] * (bodies.vx[k] * bodies.vx[k] + bodies.vy[k] * bodies.vy[k]);
        }
        return sum;
    }

    /** The deepest overlap, as a share of a radius. */
    private static double overlap(Bodies bodies, Wall[] walls) {
        double deepest = 0;
        for (int i = 0; i < bodies.size(); i++) {
            for (int j = 0; j < i; j++) {
                double dx = bodies.x[i] - bodies.x[j];
                double dy = bodies.y[i] - bodies.y[j];
                double gap = Math.sqrt(dx * dx + dy * dy) - bodies.radius[i] - bodies.radius[j];
                deepest = Math.max(deepest, -gap / bodies.radius[i]);
            }
            for (Wall wall : walls) {
                deepest = Math.max(deepest, -wall.gap(bodies.x[i], bodies.y[i], bodies.radius[i]) / bodies.radius[i]);
            }
        }
        return deepest;
    }
}
