package steward.lab.tradeoff;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;

/** What this thread has used so far: CPU time, so that other load on the machine does not count, and memory. */
final class TradeoffClock {

    private final ThreadMXBean threads =
        ManagementFactory.getThreadMXBean() instanceof ThreadMXBean known ? known : null;
    private final boolean cpu = threads != null && threads.isCurrentThreadCpuTimeSupported()
        && threads.isThreadCpuTimeEnabled();
    private final boolean bytes = threads != null && threads.isThreadAllocatedMemorySupported()
        && threads.isThreadAllocatedMemoryEnabled();

    /** Nanoseconds of CPU time; of the wall clock where the JVM does not provide it. */
    long nanos() {
        return cpu ? threads.getCurrentThreadCpuTime() : System.nanoTime();
    }

    /** Bytes allocated; 0 where {@link #tellsBytes} is false. */
    long bytes() {
        return bytes ? threads.getThreadAllocatedBytes(Thread.currentThread().getId()) : 0;
    }

    boolean tellsBytes() {
        return bytes;
    }
}
