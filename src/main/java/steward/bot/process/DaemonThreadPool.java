package steward.bot.process;

import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;

/**
 * Daemon threads for work that may block for ever. Idle threads are kept for a while and reused: a match needs several,
 * and starting them is a good part of its start and end. Blocked work keeps its thread; other work gets new ones.
 */
public final class DaemonThreadPool {

    private static final ExecutorService THREADS = Executors.newCachedThreadPool(work -> {
        Thread thread = new Thread(work, "steward-spare");
        thread.setDaemon(true);
        return thread;
    });

    private DaemonThreadPool() { }

    /**
     * Runs the work at once, on a thread of its own.
     *
     * @throws OutOfMemoryError if there are no more threads
     */
    public static void run(Runnable work) {
        THREADS.execute(work);
    }
}
