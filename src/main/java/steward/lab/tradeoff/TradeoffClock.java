package steward.lab.tradeoff;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;

/** What this thread has used so far: the time that others take on the same machine does not count. */
final class TradeoffClock {

    private final ThreadMXBean threads =
        ManagementFactory.getThreadMXBean() instanceof ThreadMXBean known ? known : null;
    private final boolean cpu = threads != null && threads.isCurrentThreadCpuTimeSupported()
        && threads.isThreadCpuTimeEnabled();
    private final boolean bytes = threads != null && threads.isThreadAllocatedMemorySupported()
        && threads.isThreadAllocatedMemoryEnabled();

    /** Nanoseconds of CPU; of the wall clock where the JVM does not tell. */
    long nanos() {
        return cpu ? threads.getCurrentThreadCpuTime() : System.nanoTime();
    }

    /** Bytes allocated; 0 where {@link #tellsBytes} is not. */
    long bytes() {
        return bytes ? threads.getThreadAllocatedBytes(Thread.currentThread().getId()) : 0;
    }

    boolean tellsBytes() {
        return bytes;
    }
}
