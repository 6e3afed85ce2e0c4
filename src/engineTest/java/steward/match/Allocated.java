package steward.match;

import static org.junit.jupiter.api.Assertions.assertEquals;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.function.LongSupplier;

/** Counts the bytes that this thread allocates. */
public final class Allocated {

    private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

    private Allocated() {
    }

    /** The bytes of some work. */
    public static long by(Runnable work) {
        long before = THREADS.getCurrentThreadAllocatedBytes();
        work.run();
        return THREADS.getCurrentThreadAllocatedBytes() - before;
    }

    /**
     * Checks that one of some counts is 0: what the JVM itself adds once, as by compiling, is not in all of them.
     *
     * @param count returns the bytes of the same work every time
     */
    public static void assertNone(int counts, String what, LongSupplier count) {
        long bytes = Long.MAX_VALUE;
        for (int k = 0; k < counts && bytes > 0; k++) {
            bytes = count.getAsLong();
        }
        assertEquals(0, bytes, "bytes: " + what);
    }
}
