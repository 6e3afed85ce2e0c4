package steward.lab.bench.section;

import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import steward.lab.bench.Comparison;
import steward.lab.bench.Contender;
import steward.lab.bench.Effort;
import steward.lab.bench.Row;
import steward.lab.bench.Section;
import steward.lab.timing.TimedWork;
import steward.lab.timing.WorkClock;
import steward.lab.trial.ImpactCount;
import steward.numerics.SplitMix64;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.Forces;
import steward.physics.HalfPlane;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.Wall;
import steward.physics.event.QueueAdvance;

/** Bench section on heaps: discs of several sizes between three walls, which gravity holds at rest. */
public final class HeapSection implements Section {

    private static final long SEED = 1;
    /** Sizes of the heaps: the first two for the least {@link Effort}, one more for each higher one. */
    private static final List<Integer> BODIES = List.of(50, 200, 1000, 5000);
    private static final double RADIUS = 15.4;
    private static final double SMALLER = 0.6;
    private static final double WIDE = 31;
    private static final double HIGH = 27;
    private static final Forces GRAVITY = new Forces(0, 0, 0, 2);
    /** Discs on their way down slide as far in one turn as in five by {@link #GRAVITY}. */
    private static final Forces LAYING = new Forces(0, 0, 0, 10);
    private static final int TURNS_TO_REST = 1000;
    /** Bodies are at rest if none is faster: far below the part that a turn adds, far above rounding. */
    private static final double STILL = 1e-8;

    @Override
    public String name() {
        return "heaps";
    }

    @Override
    public String about() {
        return "Turns of a heap at rest by CPU time: discs whose radii differ by 4%, with restitution 0.5, between a"
            + " floor and two walls, as high as wide. Five times their gravity has laid them there.";
    }

    private static List<Integer> counts(Effort effort) {
        return BODIES.subList(0, 2 + effort.ordinal());
    }

    @Override
    public int steps(Effort effort) {
        return counts(effort).size() * effort.few().steps(1);
    }

    @Override
    public void run(Effort effort, Runnable step, Consumer<Row> rows) throws Exception {
        for (int count : counts(effort)) {
            Play play = new Play(count);
            new Comparison(name(), "turns", List.of(Contender.of("at rest, " + count + " bodies", WorkClock.THREAD,
                play)), (samples, k) -> String.format(Locale.ROOT, "%d contacts, at rest after %d turns",
                play.contacts, play.turnsToRest)).run(effort.few(), step, rows);
        }
    }

    /** A heap that was laid down, turn by turn without what speed it had, and is then played. */
    private static final class Play implements TimedWork {

        private final Bodies bodies;
        private final List<Wall> walls;
        private QueueAdvance advance;
        private Forces forces;
        private final int turns;
        private final int turnsToRest;
        private long contacts;

        Play(int count) {
            int columns = (int) Math.round(Math.sqrt(count) * 0.93);
            bodies = bodies(count, columns);
            double wide = columns * WIDE + 1;
            walls = List.of(new HalfPlane(0, 0, 0, -1, 0.5), new HalfPlane(0, 0, 1, 0, 0.5),
                new HalfPlane(wide, 0, -1, 0, 0.5));
            turns = Math.max(1, 20_000 / count);
            turnsToRest = layDown(LAYING) + layDown(GRAVITY);
        }

        private static Bodies bodies(int count, int columns) {
            SplitMix64 random = new SplitMix64(SEED);
            Bodies bodies = new Bodies(count);
            int row = 0;
            int column = 0;
            while (bodies.size() < count) {
                int k = bodies.add((column + 0.5 + 0.5 * (row % 2)) * WIDE + 0.5, -WIDE / 2 - HIGH * row,
                    RADIUS - SMALLER * random.nextDouble(), 1);
                bodies.setRestitution(k, 0.5);
                column = (column + 1) % (columns - row % 2);
                row += column == 0 ? 1 : 0;
            }
            return bodies;
        }

        private int layDown(Forces by) {
            forces = by;
            advance = new QueueAdvance(new PhysicsParts(ImpactLaw.PHYSICS.withRestitution(
                ImpactLaw.Restitution.MINIMUM), Arithmetic.DOUBLE, new Contacts(1), walls, null, false)
                .withForces(forces));
            for (int turn = 1; turn <= TURNS_TO_REST; turn++) {
                turn(new ImpactCount());
                double fastest = 0;
                for (int k = 0; k < bodies.size(); k++) {
                    fastest = Math.max(fastest, Math.abs(bodies.vx[k]) + Math.abs(bodies.vy[k]));
                    bodies.setVelocity(k, 0, 0);
                }
                if (fastest < STILL) {
                    return turn;
                }
            }
            throw new IllegalStateException(bodies.size() + " bodies do not come to rest");
        }

        private void turn(ImpactCount count) {
            for (int k = 0; k < bodies.size(); k++) {
                forces.accelerate(bodies, k, 0, 0);
            }
            advance.turn(bodies, count);
        }

        @Override
        public long run() {
            ImpactCount count = new ImpactCount();
            for (int turn = 0; turn < turns; turn++) {
                turn(count);
            }
            contacts = count.impacts / turns;
            return turns;
        }
    }
}
