package steward.lab.timing;

import java.lang.management.CompilationMXBean;
import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.function.LongSupplier;
import steward.numerics.Median;

/** Timer of work in this JVM. */
public final class WorkTimer implements TimedPlace {

    /** Seconds of a stretch while warming up. */
    private static final double STRETCH = 0.02;
    /** The median of so many stretches is held against that of as many before them. */
    private static final int WINDOW = 5;
    /** Of all time, what is not timed (drawing new games) may be so many times what is. */
    private static final int MOST_UNTIMED = 10;
    /** Times are steady when these medians differ by no more than this share, and nothing was compiled meanwhile. */
    private static final double STEADY = 0.02;

    private final WorkClock clock;
    private final TimedWork work;
    /** Milliseconds for which the JVM has compiled. */
    private final LongSupplier compiled;

    /** Work of the calling thread alone, by its CPU time. */
    public WorkTimer(TimedWork work) {
        this(WorkClock.THREAD, work);
    }

    public WorkTimer(WorkClock clock, TimedWork work) {
        this(clock, work, compiling());
    }

    WorkTimer(WorkClock clock, TimedWork work, LongSupplier compiled) {
        this.clock = clock;
        this.work = work;
        this.compiled = compiled;
    }

    private static LongSupplier compiling() {
        CompilationMXBean compiler = ManagementFactory.getCompilationMXBean();
        return compiler != null && compiler.isCompilationTimeMonitoringSupported()
            ? compiler::getTotalCompilationTime : () -> 0;
    }

    @Override
    public void warmUp(double least, double most) throws Exception {
        double[] latest = new double[2 * WINDOW];
        long compiledBefore = compiled.getAsLong();
        double seconds = 0;
        boolean steady = false;
        for (int count = 1; seconds < least || !steady && seconds < most; count++) {
            Measured measured = run(Math.min(STRETCH, least));
            seconds += measured.all / NANOS;
            latest[(count - 1) % latest.length] = measured.perUnit();
            if (count % latest.length == 0) {
                double before = Median.of(Arrays.copyOf(latest, WINDOW));
                double after = Median.of(Arrays.copyOfRange(latest, WINDOW, latest.length));
                steady = Math.abs(after - before) <= STEADY * before && compiled.getAsLong() == compiledBefore;
                compiledBefore = compiled.getAsLong();
            }
        }
    }

    @Override
    public Stretch round(double least) throws Exception {
        Measured measured = run(least);
        return new Stretch(measured.perUnit(), measured.bytes / measured.units);
    }

    /**
     * Some pieces together.
     *
     * @param nanos spent in them
     * @param all   with what is not timed between them
     */
    private record Measured(long nanos, long all, double bytes, long units) {

        double perUnit() {
            return nanos / (double) units;
        }
    }

    private Measured run(double least) throws Exception {
        long used = 0;
        double allocated = 0;
        long units = 0;
        long begin = clock.nanos();
        long all;
        do {
            for (int k = 0; k < work.cycle(); k++) {
                work.prepare();
                double bytesBefore = clock.bytes();
                long before = clock.nanos();
                units += work.run();
                used += clock.nanos() - before;
                allocated += clock.bytes() - bytesBefore;
            }
            if (Thread.interrupted()) {
                throw new InterruptedException("interrupted");
            }
            all = clock.nanos() - begin;
        } while (used < least * NANOS && all < MOST_UNTIMED * least * NANOS);
        return new Measured(used, all, allocated, units);
    }
}
