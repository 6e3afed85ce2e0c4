package steward.game.podrace;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;

/**
 * Plays a {@link PodRaceBatch} with several threads, each a range of the games. Games know nothing of each other, so
 * that the results do not depend on the number of threads. The caller's thread plays the first range.
 */
public final class ParallelBatch implements AutoCloseable {

    private final List<Callable<Void>> ranges = new ArrayList<>();
    private final ExecutorService others;
    private PodRaceBatch.Commands commands;

    /**
     * @param threads 1..1024; no more than there are games are used
     * @throws IllegalArgumentException if that is not so
     */
    public ParallelBatch(PodRaceBatch batch, int threads) {
        if (threads < 1 || threads > 1024) {
            throw new IllegalArgumentException(threads + " threads, expected 1..1024");
        }
        int used = Math.min(threads, batch.games());
        for (int k = 0; k < used; k++) {
            int first = (int) ((long) batch.games() * k / used);
            int end = (int) ((long) batch.games() * (k + 1) / used);
            PodTurn kernel = batch.kernel();
            ranges.add(() -> {
                batch.play(commands, kernel, first, end);
                return null;
            });
        }
        others = Executors.newFixedThreadPool(Math.max(1, used - 1), work -> {
            Thread thread = new Thread(work, "pod-race-batch");
            thread.setDaemon(true);
            return thread;
        });
    }

    /** Plays a turn of every game. */
    public void play(PodRaceBatch.Commands turn) throws InterruptedException {
        commands = turn;
        List<Future<Void>> running = new ArrayList<>();
        for (Callable<Void> range : ranges.subList(1, ranges.size())) {
            running.add(others.submit(range));
        }
        try {
            ranges.get(0).call();
            for (Future<Void> range : running) {
                range.get();
            }
        } catch (ExecutionException problem) {
            throw new IllegalStateException(problem.getCause());
        } catch (InterruptedException | RuntimeException problem) {
            throw problem;
        } catch (Exception problem) {
            throw new IllegalStateException(problem);
        }
    }

    /** Lets the threads go. */
    @Override
    public void close() {
        others.shutdown();
    }
}
