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
import steward.lab.trial.Probe;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.TextbookSimulator;
import steward.physics.event.QueueAdvance;

/** Bench section on crowds: elastic discs in a box, at 10% coverage, from a few to a million. */
public final class CrowdSection implements Section {

    private static final double COVERAGE = 0.1;
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
            + " 64 bytes, read one after the other at random places of as much memory as the queue has.";
    }

    @Override
    public int steps(Effort effort) {
        return gases.stream().mapToInt(gas -> 2 * effort(gas, effort).steps(1)).sum();
    }

    private static TimingEffort effort(Gas gas, Effort effort) {
        return effort == Effort.QUICK || gas.count() > MOST_FOR_ROUNDS ? effort.few() : effort.timing();
    }

    /** A crowd that is played from its start until there were so many impacts. */
    private static final class Play implements TimedWork {

        private final Gas gas;
        private final long impacts;
        private QueueAdvance advance;
        private Bodies bodies;
        /** Size of the arrays of the advance, in bytes. */
        private double bytes;

        Play(Gas gas, long impacts) {
            this.gas = gas;
            this.impacts = impacts;
        }

        @Override
        public void prepare() {
            bodies = gas.bodies();
            advance = new QueueAdvance(new PhysicsParts(ImpactLaw.PHYSICS.withMaximumImpacts(Integer.MAX_VALUE),
                Arithmetic.DOUBLE, new Contacts(1), List.of(gas.walls()), null, false));
        }

        @Override
        public long run() {
            Probe probe = new Probe();
            bytes = -WorkClock.THREAD.bytes();
            while (probe.impacts < impacts) {
                advance.turn(bodies, probe);
            }
            bytes += WorkClock.THREAD.bytes();
            return probe.impacts;
        }
    }

    @Override
    public void run(Effort effort, Runnable step, Consumer<Row> rows) throws Exception {
        for (Gas gas : gases) {
            int size = gas.count();
            String bodies = size + (size == 1 ? " body" : " bodies");
            long impacts = effort == Effort.QUICK ? Math.max(2_000, size) : Math.max(200_000, 5L * size);
            Play queue = new Play(gas, impacts);
            List<Contender> contenders = new ArrayList<>();
            if (size <= MOST_FOR_TEXTBOOK) {
                contenders.add(Contender.of("textbook, " + bodies, WorkClock.THREAD,
                    textbook(gas, size > 500 ? impacts / 8 : impacts)));
            }
            contenders.add(Contender.of("queue, " + bodies, WorkClock.THREAD, queue));
            new Comparison(name(), "impacts", contenders, (samples, k) -> k < contenders.size() - 1 ? ""
                : String.format(Locale.ROOT, "%.0f bytes a body", queue.bytes / size))
                .run(effort(gas, effort), step, rows);
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
