package steward.bot.process;

import java.util.Arrays;
import java.util.concurrent.locks.LockSupport;

/**
 * The one thread of this JVM that checks all deadlines. The threads that play are blocked in reads and writes
 * meanwhile; setting a deadline costs them a volatile store, and a wake-up of this thread only if it would otherwise
 * sleep beyond the deadline.
 *
 * <p>No deadline is missed: the setting thread stores the deadline first and reads {@link #planned} second; this thread
 * stores {@link #planned} first and checks the deadlines again second. One of the two sees the other's store.
 */
final class Watchdog implements Runnable {

    /** The longest sleep while there are bots, in nanoseconds; at each wake-up their stderr is bounded. */
    static final long TICK = 50_000_000;

    /** The clock starts at one second, so that small numbers are never times. */
    private static final long ORIGIN = System.nanoTime() - 1_000_000_000;

    private volatile Deadline[] watched = {};

    /** When this thread will check again; while it is checking, any time. */
    private volatile long planned = Long.MAX_VALUE;

    private volatile Thread thread;

    private Watchdog() { }

    private static final class Shared {
        static final Watchdog INSTANCE = start();

        private static Watchdog start() {
            Watchdog watchdog = new Watchdog();
            Thread thread = new Thread(watchdog, "steward-watchdog");
            thread.setDaemon(true);
            watchdog.thread = thread;
            thread.start();
            return watchdog;
        }
    }

    /** The watchdog of this JVM; the first call starts its thread. */
    static Watchdog shared() {
        return Shared.INSTANCE;
    }

    /** The time on the clock of all deadlines, in nanoseconds; positive. */
    static long now() {
        return System.nanoTime() - ORIGIN;
    }

    synchronized void add(Deadline deadline) {
        Deadline[] more = Arrays.copyOf(watched, watched.length + 1);
        more[watched.length] = deadline;
        watched = more;
        LockSupport.unpark(thread);
    }

    synchronized void remove(Deadline deadline) {
        watched = Arrays.stream(watched).filter(each -> each != deadline).toArray(Deadline[]::new);
    }

    /** To be called after storing a deadline that has to be checked by {@code time}. */
    void look(long time) {
        if (time < planned) {
            LockSupport.unpark(thread);
        }
    }

    @Override
    public void run() {
        for (;;) {
            long now = now();
            long overslept = Math.max(0, now - planned);
            for (Deadline deadline : watched) {
                deadline.check(now, overslept);
            }
            long next = earliest(now);
            planned = next;
            if (earliest(now) < next) {
                continue;
            }
            if (next == Long.MAX_VALUE) {
                LockSupport.park(this);
            } else {
                LockSupport.parkNanos(this, next - now());
            }
        }
    }

    private long earliest(long now) {
        long earliest = Long.MAX_VALUE;
        for (Deadline deadline : watched) {
            earliest = Math.min(earliest, deadline.nextLook(now));
        }
        return earliest;
    }
}
