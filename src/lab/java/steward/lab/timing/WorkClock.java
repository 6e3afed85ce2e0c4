package steward.lab.timing;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;

/** Use of this thread so far: CPU time, so that other load on the machine does not count, and memory. */
public final class WorkClock {

    private final ThreadMXBean threads =
        ManagementFactory.getThreadMXBean() instanceof ThreadMXBean known ? known : null;
    private final boolean cpu = threads != null && threads.isCurrentThreadCpuTimeSupported()
        && threads.isThreadCpuTimeEnabled();
    private final boolean bytes = threads != null && threads.isThreadAllocatedMemorySupported()
        && threads.isThreadAllocatedMemoryEnabled();

    /** Nanoseconds of CPU time; of the wall clock where the JVM does not provide it. */
    public long nanos() {
        return cpu ? threads.getCurrentThreadCpuTime() : System.nanoTime();
    }

    /** Bytes allocated; 0 where {@link #tellsBytes} is false. */
    public long bytes() {
        return bytes ? threads.getThreadAllocatedBytes(Thread.currentThread().getId()) : 0;
    }

    /** True if the JVM tells what is allocated. */
    public boolean tellsBytes() {
        return bytes;
    }
}
