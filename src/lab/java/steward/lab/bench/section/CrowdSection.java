package steward.lab.bench.section;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import steward.lab.bench.Comparison;
import steward.lab.bench.Contender;
import steward.lab.bench.Effort;
import steward.lab.bench.Row;
import steward.lab.bench.Section;
import steward.lab.timing.TimedWork;
import steward.lab.timing.TimingEffort;
import steward.lab.timing.WorkClock;
import steward.lab.trial.Gas;
import steward.lab.trial.ImpactCount;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.TextbookSimulator;
import steward.physics.event.QueueAdvance;

/** Bench section on crowds: elastic discs in a box, from a few to a million, at 10% coverage and far denser. */
public final class CrowdSection implements Section {

    private static final double COVERAGE = 0.1;
    private static final List<Double> DENSE = List.of(0.6, 0.75);
    /** From this number of bodies on, dense crowds are measured too: walls hardly count. */
    private static final int FEWEST_DENSE = 10_000;
    /** Velocities of dense crowds are divided by this: a turn has about as many impacts as at 10%. */
    private static final double SLOWER = 32;
    private static final long SEED = 1;
    /** Beyond this number of bodies the textbook's way takes too long to measure. */
    private static final int MOST_FOR_TEXTBOOK = 3000;
    /** Beyond this number a round takes seconds. */
    private static final int MOST_FOR_ROUNDS = 30_000;
    /** Bytes of a line of the caches. */
    private static final int LINE = 64;
    private static final int LINES = 1_000_000;

    private final List<Gas> gases;

    /**
     * @param bodies the numbers of bodies, a gas for each
     * @throws IllegalArgumentException if so many are not possible, with a readable message
     */
    public CrowdSection(List<Integer> bodies) {
        gases = bodies.stream().map(count -> new Gas(SEED, count, COVERAGE)).toList();
    }

    @Override
    public String name() {
        return "crowds";
    }

    @Override
    public String about() {
        return "Impacts per second of CPU time among equal elastic discs in a box, 10% of which they cover: a textbook"
            + " event queue that predicts anew against every other body, and our queue with cells. Beside them lines of"
            + " 64 bytes, read one after the other at random places of as much memory as the queue has. From"
            + " 10,000 discs on the queue has rows at 60% and 75%; their ratio is to 10%.";
    }

    @Override
    public int steps(Effort effort) {
        return gases.stream().mapToInt(gas -> effort(gas, effort).steps(gas.count() <= MOST_FOR_TEXTBOOK ? 2
            : isDense(gas) ? 1 + DENSE.size() : 1) + effort(gas, effort).steps(1)).sum();
    }

    private static boolean isDense(Gas gas) {
        return gas.count() >= FEWEST_DENSE;
    }

    private static TimingEffort effort(Gas gas, Effort effort) {
        return effort == Effort.QUICK || gas.count() > MOST_FOR_ROUNDS ? effort.few() : effort.timing();
    }

    /** A crowd that is played from its start until there were so many impacts. */
    private static final class Play implements TimedWork {

        private final Gas gas;
        private final long impacts;
        private final double slower;
        private QueueAdvance advance;
        private Bodies bodies;
        /** Size of the arrays of the advance, in bytes. */
        private double bytes;

        Play(Gas gas, long impacts, double slower) {
            this.gas = gas;
            this.impacts = impacts;
            this.slower = slower;
        }

        @Override
        public void prepare() {
            bodies = gas.bodies();
            for (int k = 0; k < bodies.size(); k++) {
                bodies.setVelocity(k, bodies.vx[k] / slower, bodies.vy[k] / slower);
            }
            advance = new QueueAdvance(new PhysicsParts(ImpactLaw.PHYSICS.withMaximumImpacts(Integer.MAX_VALUE),
                Arithmetic.DOUBLE, new Contacts(1), List.of(gas.walls()), null, false));
        }

        @Override
        public long run() {
            ImpactCount count = new ImpactCount();
            bytes = -WorkClock.THREAD.bytes();
            while (count.impacts < impacts) {
                advance.turn(bodies, count);
            }
            bytes += WorkClock.THREAD.bytes();
            return count.impacts;
        }
    }

    @Override
    public void run(Effort effort, Runnable step, Consumer<Row> rows) throws Exception {
        for (Gas gas : gases) {
            int size = gas.count();
            String bodies = size + (size == 1 ? " body" : " bodies");
            long impacts = effort == Effort.QUICK ? Math.max(2_000, size) : Math.max(200_000, 5L * size);
            Play queue = new Play(gas, impacts, 1);
            List<Contender> contenders = new ArrayList<>();
            if (size <= MOST_FOR_TEXTBOOK) {
                contenders.add(Contender.of("textbook, " + bodies, WorkClock.THREAD,
                    textbook(gas, size > 500 ? impacts / 8 : impacts)));
            }
            contenders.add(Contender.of("queue, " + bodies, WorkClock.THREAD, queue));
            int queues = contenders.size() - 1;
            for (double coverage : isDense(gas) ? DENSE : List.<Double>of()) {
                contenders.add(Contender.of(String.format(Locale.ROOT, "queue, %s at %.0f%%", bodies, 100 * coverage),
                    WorkClock.THREAD, new Play(new Gas(SEED, size, coverage), impacts, SLOWER)));
            }
            new Comparison(name(), "impacts", contenders, (samples, k) -> k != queues ? "" : String.format(
                Locale.ROOT, "%.0f bytes a body", queue.bytes / size)).run(effort(gas, effort), step, rows);
            new Comparison(name(), "lines",
                List.of(Contender.of("memory, " + bodies, WorkClock.THREAD, lines((long) queue.bytes))),
                (samples, k) -> String.format(Locale.ROOT, "%.1f MB", queue.bytes / 1e6))
                .run(effort(gas, effort), step, rows);
        }
    }

    private static TimedWork textbook(Gas gas, long impacts) {
        return () -> {
            TextbookSimulator crowd = new TextbookSimulator(gas.bodies(), gas.side(), (time, a, b) -> { });
            crowd.play(impacts);
            return crowd.impacts();
        };
    }

    /** Lines of memory, each read at a place that the one before decides. */
    private static TimedWork lines(long bytes) {
        int count = (int) (bytes / LINE) + 1;
        long[] memory = new long[count * (LINE / Long.BYTES)];
        return () -> {
            long place = SEED;
            for (int read = 0; read < LINES; read++) {
                place = place * 0x5851f42d4c957f2dL + 0x14057b7ef767814fL + memory[(int) (place >>> 33) % count << 3];
            }
            return place == 0 ? 0 : LINES;             // a place that nobody uses would not be computed
        };
    }
}
