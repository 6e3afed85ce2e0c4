package steward.lab.timing;

import com.sun.management.OperatingSystemMXBean;
import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.function.DoubleSupplier;
import java.util.function.LongSupplier;

/**
 * Clock of a measurement in nanoseconds, with a count of the bytes that are allocated meanwhile.
 *
 * @param time      so far
 * @param allocated so far; NaN where nobody tells
 */
public record WorkClock(LongSupplier time, DoubleSupplier allocated) {

    private static final ThreadMXBean THREADS =
        ManagementFactory.getThreadMXBean() instanceof ThreadMXBean known ? known : null;
    private static final boolean TELLS_TIME = THREADS != null && THREADS.isCurrentThreadCpuTimeSupported()
        && THREADS.isThreadCpuTimeEnabled();
    private static final boolean TELLS_BYTES = THREADS != null && THREADS.isThreadAllocatedMemorySupported()
        && THREADS.isThreadAllocatedMemoryEnabled();

    /** The wall clock: for work that waits for other programs. */
    public static final WorkClock WALL = new WorkClock(System::nanoTime, () -> Double.NaN);
    /** CPU time of the calling thread, which works alone; the wall clock where the JVM does not tell it. */
    public static final WorkClock THREAD = new WorkClock(
        TELLS_TIME ? THREADS::getCurrentThreadCpuTime : System::nanoTime,
        () -> TELLS_BYTES ? THREADS.getThreadAllocatedBytes(Thread.currentThread().getId()) : Double.NaN);
    /** CPU time of the whole JVM, because other threads work as well; what all threads that live have allocated. */
    public static final WorkClock JVM = new WorkClock(
        ManagementFactory.getOperatingSystemMXBean() instanceof OperatingSystemMXBean system
            ? system::getProcessCpuTime : System::nanoTime,
        () -> TELLS_BYTES ? Arrays.stream(THREADS.getThreadAllocatedBytes(THREADS.getAllThreadIds()))
            .filter(bytes -> bytes > 0).sum() : Double.NaN);

    /** Returns the time so far, in nanoseconds. */
    public long nanos() {
        return time.getAsLong();
    }

    /** Returns the bytes allocated so far. */
    public double bytes() {
        return allocated.getAsDouble();
    }
}
