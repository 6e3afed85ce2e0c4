package steward.lab.calibration;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.StringJoiner;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.LongFunction;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import steward.contest.WorkerThreads;
import steward.game.GameSetup;
import steward.lab.oracle.TurnTruth;
import steward.lab.timing.RungJob;
import steward.lab.timing.Timing;
import steward.lab.timing.TimingSamples;
import steward.numerics.StateHash;
import steward.physics.Advance;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.PhysicsParts;
import steward.physics.TurnSink;
import steward.scene.Accuracy;
import steward.scene.AccuracyFigures;
import steward.scene.PhysicsFingerprint;
import steward.scene.RungLaw;
import steward.scene.SceneKey;

/*
 * Work is counted: the same on every machine, but a pair test of one rung is not that of another, so the order of the
 * rungs comes from costs that are timed. A turn scans all pairs, and all bodies and walls, once per step, or once more
 * than there are moments with impacts. What is counted are pair tests and impacts.
 */

/**
 * Measurement of each rung's error after one turn over many states of seeded play of a scene, compared with the oracle.
 * The error is the largest position error of a body before positions are rounded at the end of a turn (rounding would
 * hide most errors and magnify a few). States come in blocks, each from a play with a seed of its own, so that any
 * number of threads gives the same figures; finished blocks can be read at any time.
 */
public final class Calibration {

    /** How many states a calibration has by default. */
    public static final int STATES = 100_000;
    /** The rung on which the games are played that states come from, whatever the scene's rung. */
    public static final Accuracy PLAYED_ON = Accuracy.event(Arithmetic.DOUBLE);
    /** States per play; the first block is also the sample that shows whether stored figures still hold. */
    public static final int BLOCK = 1000;

    private static final int DIGITS = 3;
    private static final double LEAST_PLAIN = 1e-3;
    /** How many of the first states are timed. */
    private static final int TIMED = 512;
    /** The rung whose cost is 1. */
    private static final Accuracy UNIT = Accuracy.event(Arithmetic.DOUBLE);

    private final GameSetup setup;
    private final LongFunction<SeededPlay> plays;
    private final PhysicsParts parts;
    private final List<Accuracy> rungs;
    private final int states;
    private final Block[] blocks;
    private final AtomicInteger next = new AtomicInteger();
    private TimingSamples samples;

    /** The results of a block of states. */
    private record Block(double[][] errors, double[] work, int withImpacts) { }

    /**
     * The figures of a calibration.
     *
     * @param states      how many states were measured
     * @param withImpacts how many of these had impacts
     * @param rungs       the figures of each rung, in the order of the ladder
     * @param sample      a hash of the errors of the first block
     */
    public record Figures(int states, int withImpacts, double unitNanos, List<AccuracyFigures.OfRung> rungs,
                          String sample) { }

    /**
     * @param setup  a scene, opened on {@link #PLAYED_ON}
     * @param states how many states, at least 1
     */
    public Calibration(GameSetup setup, LongFunction<SeededPlay> plays, int states) {
        this.setup = setup;
        this.plays = plays;
        this.states = states;
        parts = setup.physics();
        int most = mostSteps(setup.plan().bodies());
        rungs = Accuracy.ladder().stream().filter(rung -> rung.steps() <= most).toList();
        blocks = new Block[(states + BLOCK - 1) / BLOCK];
    }

    /** Returns the most steps a turn that are measured of so many bodies: steps look at all pairs. */
    public static int mostSteps(int bodies) {
        return bodies <= 64 ? Integer.MAX_VALUE : bodies <= 300 ? 256 : 64;
    }

    /**
     * Measures the remaining blocks.
     *
     * @param threads how many
     * @param done    called by any of the threads after each block
     * @throws InterruptedException if the calling thread is interrupted; results so far are kept
     */
    public void run(int threads, Runnable done) throws InterruptedException {
        WorkerThreads.run("calibration of " + setup.scene().name(), threads, k -> () -> {
            work(done);
            return null;
        });
    }

    private void work(Runnable done) {
        for (int k = next.getAndIncrement(); k < blocks.length; k = next.getAndIncrement()) {
            Block block = measure(k, Math.min(BLOCK, states - k * BLOCK));
            synchronized (blocks) {
                blocks[k] = block;
            }
            done.run();
        }
    }

    /** Returns how many jobs {@link #time} times. */
    public int jobs() {
        return rungs.size();
    }

    /**
     * Times the rungs on the first states; before this there are no figures.
     *
     * @param timing times the job of each
     * @param step   called after each step of it
     */
    public void time(Timing<RungJob> timing, Runnable step) {
        SeededPlay play = plays.apply(0);
        List<Bodies> timed = Stream.generate(play::next).limit(Math.min(TIMED, states)).toList();
        String scene = setup.scene().json();
        TimingSamples measured = timing.run(rungs.stream()
            .map(rung -> new RungJob(scene, rung, setup.plan().bodies(), timed)).toList(), step);
        synchronized (blocks) {
            samples = measured;
        }
    }

    public int blocks() {
        return blocks.length;
    }

    private Block measure(int number, int count) {
        SeededPlay play = plays.apply(number);
        List<Advance> advances = rungs.stream().map(rung -> rung.advance(parts.withArithmetic(rung.arithmetic())))
            .toList();
        double[][] errors = new double[rungs.size()][count];
        double[] work = new double[rungs.size()];
        int withImpacts = 0;
        Moments moments = new Moments();
        for (int k = 0; k < count; k++) {
            Bodies start = play.next();
            TurnTruth truth = TurnTruth.of(start, parts);
            withImpacts += truth.impacts() > 0 ? 1 : 0;
            Bodies bodies = start.copy();
            for (int r = 0; r < advances.size(); r++) {
                bodies.copyFrom(start);
                moments.clear();
                advances.get(r).turn(bodies, moments);
                errors[r][k] = truth.limited() ? Double.POSITIVE_INFINITY : truth.positionError(bodies);
                work[r] += work(rungs.get(r), moments, tests(start));
            }
        }
        return new Block(errors, work, withImpacts);
    }

    /** Returns how many pairs, and bodies with walls, a scan tests. */
    private int tests(Bodies bodies) {
        int movable = (int) IntStream.range(0, bodies.size()).filter(k -> bodies.inverseMass[k] > 0).count();
        int fixed = bodies.size() - movable;
        return movable * (movable - 1) / 2 + movable * fixed + movable * parts.walls().size();
    }

    private static double work(Accuracy rung, Moments moments, int tests) {
        double looks = rung.way() == Accuracy.Way.STEP ? rung.steps() : moments.moments + 1;
        return looks * tests + moments.impacts;
    }

    /** Counts impacts, and the distinct times at which there are any. */
    private static final class Moments implements TurnSink {

        private long impacts;
        private int moments;
        private double last;

        void clear() {
            impacts = 0;
            moments = 0;
            last = -1;
        }

        @Override
        public void impact(double time, int a, int b, double ax, double ay, double bx, double by, double nx,
                           double ny, double j, double energy, double massA, double massB, double vax, double vay,
                           double vaxAfter, double vayAfter, double vbx, double vby, double vbxAfter,
                           double vbyAfter) {
            impacts++;
            moments += time == last ? 0 : 1;
            last = time;
        }
    }

    /**
     * Figures of all blocks that are complete without a gap from the first on; of 0 states if there are none, or
     * nothing was timed.
     */
    public Figures figures() {
        List<Block> done;
        TimingSamples timed;
        synchronized (blocks) {
            done = samples == null ? List.of() : Arrays.stream(blocks).takeWhile(block -> block != null).toList();
            timed = samples;
        }
        int count = done.stream().mapToInt(block -> block.errors[0].length).sum();
        List<AccuracyFigures.OfRung> figures = new ArrayList<>();
        for (int r = 0; r < rungs.size() && count > 0; r++) {
            int rung = r;
            double[] errors = done.stream().flatMapToDouble(block -> Arrays.stream(block.errors[rung])).sorted()
                .toArray();
            double work = 0;
            for (Block block : done) {
                work += block.work[r];
            }
            figures.add(new AccuracyFigures.OfRung(rungs.get(r),
                PhysicsFingerprint.of(RungLaw.of(rungs.get(r), parts.law(),
                    parts.forces().act())), timed.ratio(r, rungs.indexOf(UNIT)),
                work / count,
                AccuracyFigures.SHARES.stream().map(share -> atShare(errors, share)).toList(),
                errors[errors.length - 1]));
        }
        return new Figures(count, done.stream().mapToInt(Block::withImpacts).sum(),
            count == 0 ? Double.NaN : timed.median(rungs.indexOf(UNIT)), figures,
            done.isEmpty() ? "" : sample(done.get(0)));
    }

    /**
     * The least error seen that at least this share of all states does not exceed, shown with
     * {@link BinomialTail#CONFIDENCE}; infinite if there are too few states to show it.
     */
    static double atShare(double[] sorted, String share) {
        int allowed = BinomialTail.allowed(sorted.length, Double.parseDouble(share));
        return allowed < 0 ? Double.POSITIVE_INFINITY : sorted[sorted.length - 1 - allowed];
    }

    private static String sample(Block block) {
        StateHash hash = new StateHash();
        for (double[] errors : block.errors) {
            for (double error : errors) {
                hash.add(error);
            }
        }
        return StateHash.toHex(hash.value());
    }

    /**
     * The figures as a file that {@link AccuracyFigures} reads; errors are rounded up to three digits.
     *
     * @param date    of the measurement, as year-month-day
     * @param machine on which the rungs were timed
     */
    public String text(Figures figures, String date, String machine) {
        StringJoiner rungs = new StringJoiner(",\n    ", "[\n    ", "\n  ]");
        for (AccuracyFigures.OfRung rung : figures.rungs) {
            String errors = IntStream.range(0, rung.errors().size()).mapToObj(k -> "\"" + AccuracyFigures.SHARES.get(k)
                + "\": " + number(rung.errors().get(k))).collect(Collectors.joining(", ", "{ ", " }"));
            rungs.add("{ \"rung\": \"" + rung.rung() + "\", \"physics\": \"" + rung.physics() + "\",\n      \"cost\": "
                + number(rung.cost()) + ", \"work\": " + number(rung.work()) + ", \"largestError\": "
                + number(rung.largest()) + ",\n      \"positionErrors\": " + errors + " }");
        }
        return "{\n  \"format\": " + AccuracyFigures.FORMAT + ",\n  \"key\": \"" + SceneKey.of(setup.scene())
            + "\",\n  \"sample\": \"" + figures.sample
            + "\",\n  \"states\": " + figures.states + ",\n  \"statesWithImpacts\": " + figures.withImpacts
            + ",\n  \"timed\": { \"date\": \"" + date + "\", \"machine\": \"" + machine.replaceAll("[\"\\\\]", "'")
            + "\" },\n  \"unitNanos\": " + number(figures.unitNanos) + ",\n  \"rungs\": " + rungs + "\n}\n";
    }

    private static String number(double value) {
        if (value == 0 || value == Double.POSITIVE_INFINITY) {
            return value == 0 ? "0" : '"' + AccuracyFigures.UNKNOWN + '"';
        }
        BigDecimal rounded = new BigDecimal(value).round(new MathContext(DIGITS, RoundingMode.CEILING))
            .stripTrailingZeros();
        return value < LEAST_PLAIN ? rounded.toString().toLowerCase(Locale.ROOT) : rounded.toPlainString();
    }
}
