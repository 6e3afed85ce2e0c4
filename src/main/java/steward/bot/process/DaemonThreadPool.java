package steward.bot.process;

import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;

/**
 * Daemon threads for work that may block for ever, kept for some time for who comes next: a match needs several, and
 * starting them is a good part of its start and end. Whoever gets stuck keeps its thread, and the others get new ones.
 */
public final class DaemonThreadPool {

    private static final ExecutorService THREADS = Executors.newCachedThreadPool(work -> {
        Thread thread = new Thread(work, "steward-spare");
        thread.setDaemon(true);
        return thread;
    });

    private DaemonThreadPool() {
    }

    /**
     * Runs it at once, on a thread that does nothing else meanwhile.
     *
     * @throws OutOfMemoryError if there are no more threads
     */
    public static void run(Runnable work) {
        THREADS.execute(work);
    }
}
