package steward.contest;

import java.util.concurrent.Callable;
import java.util.concurrent.CompletionService;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorCompletionService;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.ThreadFactory;
import java.util.function.IntFunction;

/** Daemon threads, each of which repeats a task until no work is left. */
public final class WorkerThreads {

    private WorkerThreads() { }

    /** Makes daemon threads of one name. */
    public static ThreadFactory daemons(String name) {
        return task -> {
            Thread thread = new Thread(task, name);
            thread.setDaemon(true);
            return thread;
        };
    }

    /**
     * Works until all threads are done. As soon as one fails the others are interrupted.
     *
     * @param work of each of them, by its number
     * @throws RuntimeException what a thread failed with
     */
    public static void run(String name, int threads, IntFunction<Callable<Void>> work) throws InterruptedException {
        ExecutorService pool = Executors.newFixedThreadPool(threads, daemons(name));
        try {
            CompletionService<Void> working = new ExecutorCompletionService<>(pool);
            for (int k = 0; k < threads; k++) {
                working.submit(work.apply(k));
            }
            for (int k = 0; k < threads; k++) {
                working.take().get();
            }
        } catch (ExecutionException failed) {
            if (failed.getCause() instanceof RuntimeException problem) {
                throw problem;
            }
            if (failed.getCause() instanceof Error problem) {
                throw problem;
            }
            throw new IllegalStateException("the threads of the " + name, failed.getCause());
        } finally {
            pool.shutdownNow();
        }
    }
}
