package steward.lab.bench.section;

import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import steward.lab.bench.Effort;
import steward.lab.bench.Meter;
import steward.lab.bench.Row;
import steward.lab.bench.Section;
import steward.lab.trial.Gas;
import steward.physics.Advance;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.TextbookSimulator;
import steward.physics.event.EventAdvance;
import steward.physics.queue.QueueAdvance;

/** Bench section on crowds: elastic discs in a box, at 10% coverage, from a few to a million. */
final class CrowdSection implements Section {

    private static final double COVERAGE = 0.1;
    private static final long SEED = 1;
    /** Beyond these numbers of bodies the textbook's way and the scan of all pairs take too long to measure. */
    private static final int MOST_FOR_TEXTBOOK = 3000;
    private static final int MOST_FOR_PAIRS = 300;
    /** Bytes of a line of the caches. */
    private static final int LINE = 64;
    private static final int LINES = 1_000_000;
    private static final double NANOS = 1e9;
    private static final long NANOS_PER_MS = 1_000_000;

    private final List<Gas> gases;

    /** @throws IllegalArgumentException if so many bodies are not possible */
    CrowdSection(List<Integer> bodies) {
        gases = bodies.stream().map(count -> new Gas(SEED, count, COVERAGE)).toList();
    }

    @Override
    public String name() {
        return "crowds";
    }

    @Override
    public String about() {
        return "Impacts per second of CPU time among equal elastic discs in a box, 10% of which they cover: a textbook"
            + " event queue that predicts anew against every other body, our scan of all pairs, and our queue with"
            + " cells. Beside them lines of 64 bytes, read one after the other at random places of as much memory as"
            + " the queue has.";
    }

    @Override
    public int steps(Effort effort) {
        return gases.stream().mapToInt(gas -> 1 + rounds(gas.count(), effort)).sum();
    }

    @Override
    public boolean isRough(Effort effort) {
        return effort == Effort.QUICK;
    }

    @Override
    public void run(Effort effort, Consumer<String> about, Consumer<Row> rows) {
        for (Gas gas : gases) {
            run(gas, effort, about, rows);
        }
    }

    private static int contenders(int bodies) {
        return bodies > MOST_FOR_TEXTBOOK ? 1 : bodies > MOST_FOR_PAIRS ? 2 : 3;
    }

    private static int rounds(int bodies, Effort effort) {
        return bodies > 30_000 ? effort.fewRounds() : effort == Effort.QUICK ? 1 : effort.rounds();
    }

    private void run(Gas gas, Effort effort, Consumer<String> about, Consumer<Row> rows) {
        int size = gas.count();
        long impacts = Math.max(effort == Effort.QUICK ? 2_000 : 200_000, effort == Effort.QUICK ? size : 5L * size);
        int rounds = rounds(size, effort);
        double[] textbook = new double[rounds];
        double[] pairs = new double[rounds];
        double[] queue = new double[rounds];
        long bytes = 0;
        about.accept(size + " bodies, warming up");
        Meter meter = new Meter();
        long warm = meter.cpu(false) + contenders(size) * effort.warmUpMs() * NANOS_PER_MS;
        for (int round = -1; round < rounds; round += meter.cpu(false) < warm ? 0 : 1) {
            int k = Math.max(0, round);
            if (round >= 0) {
                about.accept(size + " bodies");
            }
            textbook[k] = size > MOST_FOR_TEXTBOOK ? Double.NaN : textbook(gas, size > 500 ? impacts / 8 : impacts);
            pairs[k] = size > MOST_FOR_PAIRS ? Double.NaN : advance(new EventAdvance(parts(gas)), gas, impacts / 16);
            QueueAdvance cells = new QueueAdvance(parts(gas));
            queue[k] = advance(cells, gas, impacts);
            bytes = cells.bytes();
        }
        double base = Meter.median(textbook);
        String bodies = size + (size == 1 ? " body" : " bodies");
        add(rows, "textbook, " + bodies, base, base, "");
        add(rows, "all pairs, " + bodies, Meter.median(pairs), base, "");
        add(rows, "queue, " + bodies, Meter.median(queue), base,
            String.format(Locale.ROOT, "%.0f bytes a body", (double) bytes / size));
        double[] lines = new double[effort.rounds()];
        for (int round = 0; round < lines.length; round++) {
            lines[round] = lines(bytes);
        }
        rows.accept(new Row(name(), "memory, " + bodies, "lines", Meter.median(lines), Double.NaN, Double.NaN,
            String.format(Locale.ROOT, "%.1f MB", bytes / 1e6)));
    }

    /** Lines of memory read per second, each at a place that the one before decides. */
    private static double lines(long bytes) {
        int count = (int) (bytes / LINE) + 1;
        long[] memory = new long[count * (LINE / Long.BYTES)];
        Meter meter = new Meter();
        long start = meter.cpu(false);
        long place = SEED;
        for (int read = 0; read < LINES; read++) {
            place = place * 0x5851f42d4c957f2dL + 0x14057b7ef767814fL + memory[(int) (place >>> 33) % count << 3];
        }
        double nanos = meter.cpu(false) - start;
        return place == 0 ? Double.NaN : NANOS * LINES / nanos;   // a place that nobody uses would not be computed
    }

    private void add(Consumer<Row> rows, String name, double speed, double base, String note) {
        if (!Double.isNaN(speed)) {
            rows.accept(new Row(name(), name, "impacts", speed, speed / base, Double.NaN, note));
        }
    }

    private static PhysicsParts parts(Gas gas) {
        return new PhysicsParts(ImpactLaw.PHYSICS.withMaximumImpacts(Integer.MAX_VALUE), Arithmetic.DOUBLE,
            new Contacts(1), List.of(gas.walls()), null, false);
    }

    private static double textbook(Gas gas, long impacts) {
        Meter meter = new Meter();
        TextbookSimulator crowd = new TextbookSimulator(gas.bodies(), gas.side(), (time, a, b) -> {
        });
        long before = crowd.impacts();
        long start = meter.cpu(false);
        crowd.play(impacts);
        return NANOS * (crowd.impacts() - before) / (meter.cpu(false) - start);
    }

    private static double advance(Advance advance, Gas gas, long impacts) {
        Meter meter = new Meter();
        Bodies bodies = gas.bodies();
        ImpactCounter count = new ImpactCounter();
        long start = meter.cpu(false);
        while (count.impacts() < impacts) {
            advance.turn(bodies, count);
        }
        return NANOS * count.impacts() / (meter.cpu(false) - start);
    }
}
