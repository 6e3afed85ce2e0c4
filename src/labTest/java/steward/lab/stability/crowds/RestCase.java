package steward.lab.stability.crowds;

import java.math.BigDecimal;
import java.util.ArrayList;
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
import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.HalfPlane;
import steward.physics.Impact;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.TurnLog;
import steward.physics.Wall;

/**
 * Stability case of rest: piles without restitution fall or are pressed on a wall or into a corner, and must come to
 * rest.
 */
public final class RestCase extends StabilityCase {

    private static final long SEED = 18;
    private static final int TURNS = 40;
    private static final int MOST_IMPACTS = 500;
    private static final double STILL = 1e-9;
    /** Piles of up to so many bodies are compared with the oracle's. */
    private static final int COMPARED = 12;
    private static final double MOST_OFF = 1e-9;
    /** Height of a row that lies in the gaps of the row below: half of the root of 3. */
    private static final double HEIGHT = 0.8660254037844387;
    /** Added energy, so that the growth of nothing is a number. */
    private static final BigDecimal TINY = new BigDecimal(1e-30);
    private static final ImpactLaw SOFT = ImpactLaw.PHYSICS.withRestitution(ImpactLaw.Restitution.MINIMUM);

    public RestCase() {
        super("rest",
            "columns, grids and staggered rows of 1 to 30 bodies without restitution, of random radii and masses, "
            + "with gaps of 0 to 1e-1 radii and jitter. They are thrown once, or pressed anew each turn against a "
            + "wall or into a corner. No turn has more than 500 impacts or reaches its limit. Energy never grows "
            + "(but for 1e-15 of it, by rounding), and momentum is booked. One by one and as a crowd are the same "
            + "to the bit. Columns are then at rest. On event rungs of ours the second turns of up to 12 bodies are"
            + " the oracle's in 19 of 20, to 1e-9 of the speeds. All else is demanded on every event rung");
    }

    @Override
    public Finding run(Rung rung, RunLength size) {
        SplitMix64 random = new SplitMix64(SEED);
        Tally tally = new Tally();
        int piles = size.pick(40, 400, 4_000);
        for (int n = 0; n < piles; n++) {
            pile(rung, random, tally);
        }
        boolean met = tally.most <= MOST_IMPACTS && tally.limited == 0 && tally.growth <= 1e-15
            && tally.unbooked <= 1e-12
            && tally.different == 0 && tally.fastest <= STILL && (tally.truth.areTrue() || !rung.isOurs());
        return Finding.of(rung.isEvent(), met, String.format(Locale.ROOT, "%d piles: at most %d impacts in a turn, %d "
            + "limited, energy grew by %.1e, momentum off by %.1e, %d turns differ as a crowd, columns keep %.1e of "
            + "their speed; %s", piles, tally.most, tally.limited, tally.growth, tally.unbooked, tally.different,
            tally.fastest, tally.truth.text()));
    }

    /** Counts over the piles of a rung. */
    private static final class Tally {

        private long most;
        private int limited;
        private double growth;
        private double unbooked;
        private int different;
        private double fastest;
        private final OracleTurns truth = new OracleTurns(MOST_OFF);
    }

    private static void pile(Rung rung, SplitMix64 random, Tally tally) {
        int count = 1 + random.nextInt(30);
        Shape shape = Shape.values()[random.nextInt(3)];
        boolean corner = random.nextInt(2) == 0;
        boolean pressed = random.nextInt(2) == 0;
        double gaps = random.nextInt(3) == 0 ? 0 : StrictMath.pow(10, -1 - 14 * random.nextDouble());
        Bodies bodies = bodies(random, count, shape, gaps);
        List<Wall> walls = new ArrayList<>();
        walls.add(new HalfPlane(0, 0, 0, 1, 0));
        if (corner) {
            walls.add(new HalfPlane(0, 0, 1, 0, 0));
        }
        Wall[] around = walls.toArray(new Wall[0]);
        PhysicsParts parts = new PhysicsParts(SOFT, rung.arithmetic(), new Contacts(1), walls, null, false);
        Advance alone = rung.maker().apply(parts);
        Advance crowd = rung.crowdAdvance(SOFT, around);
        Bodies copy = new Bodies(count);
        double speed = speed(bodies);
        for (int turn = 0; turn < TURNS; turn++) {
            if (pressed && turn > 0) {
                press(bodies, speed, corner);
            }
            Bodies before = turn == 1 && rung.isEvent() && count <= COMPARED ? bodies.copy() : null;
            play(alone, crowd, bodies, copy, tally);
            if (before != null) {
                tally.truth.add(before, bodies, parts);
            }
        }
        if (shape == Shape.COLUMN && !(pressed && corner)) {
            tally.fastest = Math.max(tally.fastest, speed(bodies) / speed);
        }
    }

    /** Gives each body a speed toward the wall, or into the corner. */
    private static void press(Bodies bodies, double speed, boolean corner) {
        for (int k = 0; k < bodies.size(); k++) {
            bodies.setVelocity(k, bodies.vx[k] - (corner ? speed : 0), bodies.vy[k] - speed);
        }
    }

    /** Layout of a pile. */
    private enum Shape { COLUMN, GRID, STAGGERED }

    /** Returns a column that falls straight, or rows with jitter that fall anyhow. */
    private static Bodies bodies(SplitMix64 random, int count, Shape shape, double gaps) {
        Bodies bodies = new Bodies(count);
        boolean column = shape == Shape.COLUMN;
        double radius = 1 + 30 * random.nextDouble();
        double speed = radius * (0.1 + 3 * random.nextDouble());
        int perRow = column ? 1 : 1 + random.nextInt(6);
        double step = 2 * radius * (1 + gaps);
        for (int k = 0; k < count; k++) {
            double jitter = gaps * radius;
            int row = k / perRow;
            boolean moved = shape == Shape.STAGGERED && row % 2 == 1;
            bodies.add(radius + step * (k % perRow) + (moved ? step / 2 : 0)
                + (column ? 0 : jitter * random.nextDouble()),
                radius + (shape == Shape.STAGGERED ? HEIGHT : 1) * step * row + jitter * random.nextDouble(), radius,
                1 + 2 * random.nextDouble());
            bodies.setVelocity(k, column ? 0 : -speed * random.nextDouble(),
                column ? -speed : -speed * (0.5 + random.nextDouble()));
            bodies.setRestitution(k, 0);
        }
        return bodies;
    }

    private static void play(Advance alone, Advance crowd, Bodies bodies, Bodies copy, Tally tally) {
        copy.copyFrom(bodies);
        BigDecimal energy = Probe.energy(bodies).add(TINY);
        double momentumX = momentum(bodies, bodies.vx);
        double momentumY = momentum(bodies, bodies.vy);
        double size = Math.abs(momentumX) + Math.abs(momentumY);
        TurnLog log = new TurnLog();
        TurnLog other = new TurnLog();
        alone.turn(bodies, log);
        crowd.turn(copy, other);
        tally.most = Math.max(tally.most, log.impacts());
        tally.limited += log.limited() ? 1 : 0;
        tally.growth = Math.max(tally.growth,
            Probe.energy(bodies).subtract(energy).doubleValue() / energy.doubleValue());
        for (int k = 0; k < log.impacts(); k++) {
            Impact impact = log.impact(k);
            momentumX -= impact.isWall() ? impact.momentumBx() : 0;
            momentumY -= impact.isWall() ? impact.momentumBy() : 0;
        }
        double off = Math.abs(momentum(bodies, bodies.vx) - momentumX)
            + Math.abs(momentum(bodies, bodies.vy) - momentumY);
        tally.unbooked = Math.max(tally.unbooked, size > 1e-6 ? off / size : 0);
        boolean same = log.impacts() == other.impacts();
        for (int k = 0; k < bodies.size(); k++) {
            same &= Probe.same(bodies, k, copy, k);
        }
        tally.different += same ? 0 : 1;
    }

    private static double momentum(Bodies bodies, double[] v) {
        double sum = 0;
        for (int k = 0; k < bodies.size(); k++) {
            sum += bodies.mass[k] * v[k];
        }
        return sum;
    }

    private static double speed(Bodies bodies) {
        double fastest = 0;
        for (int k = 0; k < bodies.size(); k++) {
            fastest = Math.max(fastest, Math.abs(bodies.vx[k]) + Math.abs(bodies.vy[k]));
        }
        return fastest;
    }
}
