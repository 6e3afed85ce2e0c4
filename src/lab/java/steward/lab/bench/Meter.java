package steward.lab.bench;

import com.sun.management.OperatingSystemMXBean;
import com.sun.management.ThreadMXBean;
import java.lang.management.CompilationMXBean;
import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import java.util.function.ToLongFunction;
import java.util.stream.IntStream;

/**
 * Measures contenders in turns, so that other load on the machine affects all of them: by CPU time, the median of
 * several rounds. Each has warmed up before: until its speed is settled and the JVM compiles no more, or until the
 * effort ends.
 */
public final class Meter {

    private static final double NANOS = 1e9;
    private static final long NANOS_PER_MS = 1_000_000;
    /** Slices of warm-up that have to be alike. */
    private static final int SETTLED_SLICES = 3;
    /** The fastest of them over the slowest, at most. */
    private static final double SETTLED = 1.05;
    /** A ratio whose rounds differ by more is not to be compared: tables are for differences beyond this. */
    private static final double COMPARABLE = 1.25;
    /** From so many rounds on, the lowest and the highest ratio do not count: something else may have run. */
    private static final int MANY_ROUNDS = 5;
    /** Pieces of work whose allocation is counted. */
    private static final int COUNTED_PIECES = 10;

    private final ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    private final OperatingSystemMXBean system = (OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();

    private final ToLongFunction<Contender.Clock> clocks;
    /** Milliseconds for which the JVM has compiled. */
    private final LongSupplier compiled;

    public Meter() {
        clocks = clock -> clock == Contender.Clock.WALL ? System.nanoTime() : cpu(clock == Contender.Clock.JVM);
        CompilationMXBean compiler = ManagementFactory.getCompilationMXBean();
        compiled = compiler != null && compiler.isCompilationTimeMonitoringSupported()
            ? compiler::getTotalCompilationTime : () -> 0;
    }

    /** A meter with other clocks, in nanoseconds. */
    Meter(ToLongFunction<Contender.Clock> clocks, LongSupplier compiled) {
        this.clocks = clocks;
        this.compiled = compiled;
    }

    private long now(Contender.Clock clock) {
        return clocks.applyAsLong(clock);
    }

    /** CPU time of the calling thread, or of the whole JVM, in nanoseconds. */
    public long cpu(boolean all) {
        return all ? system.getProcessCpuTime() : threads.getCurrentThreadCpuTime();
    }

    /**
     * Measures a row per contender; the ratio is to the first.
     *
     * @throws Exception what a contender threw, or if this thread is interrupted: then the results of the rounds before
     *     are reported first
     */
    public void compare(String section, String unit, List<Contender> contenders, Effort effort, Consumer<String> about,
                 Consumer<Row> rows) throws Exception {
        double[][] speeds = new double[contenders.size()][effort.rounds()];
        for (Contender each : contenders) {
            about.accept(each.name());
            warmUp(each, effort);
        }
        int done = 0;
        try {
            for (; done < effort.rounds(); done++) {
                for (int k = 0; k < speeds.length; k++) {
                    about.accept(contenders.get(k).name());
                    speeds[k][done] = speed(contenders.get(k), effort.roundMs());
                }
            }
        } catch (Exception problem) {                  // an interrupt appears as the failure of a write or a match
            if ((Thread.interrupted() || problem instanceof InterruptedException) && done > 0) {
                tell(section, unit, contenders, speeds, done, done + " of " + effort.rounds() + " rounds", rows);
            }
            throw problem;
        }
        tell(section, unit, contenders, speeds, done, "", rows);
    }

    private void warmUp(Contender contender, Effort effort) throws Exception {
        long begin = now(contender.clock());
        double[] last = new double[SETTLED_SLICES];
        for (int slice = 0; ; slice++) {
            long compiledBefore = compiled.getAsLong();
            double speed = speed(contender, effort.roundMs());
            boolean compiling = compiled.getAsLong() != compiledBefore;
            last[slice % SETTLED_SLICES] = compiling ? 0 : speed;
            double[] sorted = last.clone();
            Arrays.sort(sorted);
            boolean settled = sorted[0] > 0 && sorted[SETTLED_SLICES - 1] <= SETTLED * sorted[0];
            long spent = now(contender.clock()) - begin;
            if (spent >= (settled ? effort.warmUpMs() : effort.mostWarmUpMs()) * NANOS_PER_MS) {
                return;
            }
        }
    }

    /** Says that a ratio is not comparable, if its rounds differ too much; otherwise nothing. */
    private static String caution(double[] speeds, double[] first, int rounds) {
        double[] ratios = ratios(speeds, first, rounds);
        int cut = rounds >= MANY_ROUNDS ? 1 : 0;
        double low = ratios[cut];
        double high = ratios[rounds - 1 - cut];
        return high <= COMPARABLE * low ? "" : String.format(Locale.ROOT,
            "ratio not comparable: %.2f to %.2f in its rounds", low, high);
    }

    private void tell(String section, String unit, List<Contender> contenders, double[][] speeds, int rounds,
                      String note, Consumer<Row> rows) throws Exception {
        double first = median(Arrays.copyOf(speeds[0], rounds));
        for (int k = 0; k < speeds.length; k++) {
            double bytes = bytes(contenders.get(k));
            double median = median(Arrays.copyOf(speeds[k], rounds));
            rows.accept(new Row(section, contenders.get(k).name(), unit, median, median / first, bytes, note)
                .remark(caution(speeds[k], speeds[0], rounds)));
        }
    }

    /** Units per second by the contender's clock, over at least the given time. */
    private double speed(Contender contender, long ms) throws Exception {
        long units = 0;
        long start = now(contender.clock());
        long now = start;
        while (now - start < ms * NANOS_PER_MS) {
            units += contender.work().run();
            now = now(contender.clock());
            if (Thread.interrupted()) {
                throw new InterruptedException("interrupted");
            }
        }
        return NANOS * units / (now - start);
    }

    /**
     * Bytes allocated per unit by the calling thread, or by all threads that live on; NaN by the wall clock, where
     * threads come and go.
     */
    private double bytes(Contender contender) throws Exception {
        if (contender.clock() == Contender.Clock.WALL) {
            return Double.NaN;
        }
        boolean all = contender.clock() == Contender.Clock.JVM;
        long before = allocated(all);
        long units = 0;
        for (int piece = 0; piece < COUNTED_PIECES; piece++) {
            units += contender.work().run();
        }
        return (double) (allocated(all) - before) / units;
    }

    private long allocated(boolean all) {
        return all ? Arrays.stream(threads.getThreadAllocatedBytes(threads.getAllThreadIds())).filter(n -> n > 0).sum()
            : threads.getCurrentThreadAllocatedBytes();
    }

    /** Ratios of two contenders in the rounds so far, ascending. */
    public static double[] ratios(double[] one, double[] other, int rounds) {
        return IntStream.range(0, rounds).mapToDouble(round -> one[round] / other[round]).sorted().toArray();
    }

    public static double median(double[] values) {
        double[] sorted = values.clone();
        Arrays.sort(sorted);
        int middle = sorted.length / 2;
        return sorted.length % 2 == 1 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
    }
}
