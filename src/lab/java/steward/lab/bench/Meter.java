package steward.lab.bench;

import com.sun.management.OperatingSystemMXBean;
import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.List;
import java.util.function.Consumer;

/**
 * Measures contenders in turns, so that other load on the machine affects all of them: by CPU time, the median of
 * several rounds.
 */
public final class Meter {

    private static final double NANOS = 1e9;
    private static final long NANOS_PER_MS = 1_000_000;

    private final ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    private final OperatingSystemMXBean system =
        (OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();

    private long now(Contender.Clock clock) {
        return clock == Contender.Clock.WALL ? System.nanoTime() : cpu(clock == Contender.Clock.JVM);
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
            speed(each, effort.warmUpMs());
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

    private void tell(String section, String unit, List<Contender> contenders, double[][] speeds, int rounds,
                      String note, Consumer<Row> rows) throws Exception {
        double first = median(Arrays.copyOf(speeds[0], rounds));
        for (int k = 0; k < speeds.length; k++) {
            boolean countable = contenders.get(k).clock() == Contender.Clock.THREAD;
            double bytes = countable ? bytes(contenders.get(k)) : Double.NaN;
            double median = median(Arrays.copyOf(speeds[k], rounds));
            rows.accept(new Row(section, contenders.get(k).name(), unit, median, median / first, bytes, note));
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

    private double bytes(Contender contender) throws Exception {
        long before = threads.getCurrentThreadAllocatedBytes();
        long units = contender.work().run();
        return (double) (threads.getCurrentThreadAllocatedBytes() - before) / units;
    }

    public static double median(double[] values) {
        double[] sorted = values.clone();
        Arrays.sort(sorted);
        int middle = sorted.length / 2;
        return sorted.length % 2 == 1 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
    }
}
