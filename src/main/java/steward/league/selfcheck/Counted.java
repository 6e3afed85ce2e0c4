package steward.league.selfcheck;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;

/** Plays many made-up leagues on threads and adds up what was counted: whole numbers, in any order the same. */
final class Counted {

    private static final int CHUNK = 50;

    private Counted() {
    }

    /** Plays one league. */
    interface League {
        /** @param counts to be added to */
        void play(long number, long... counts);
    }

    /** Makes what plays leagues on one thread. */
    interface Player {
        League onThread();
    }

    /**
     * Plays them.
     *
     * @param numbers how many things are counted
     * @return the counts
     */
    static long[] play(int threads, long leagues, int numbers, Player player) throws InterruptedException {
        ExecutorService workers = Executors.newFixedThreadPool(threads, work -> {
            Thread thread = new Thread(work, "self-check");
            thread.setDaemon(true);
            return thread;
        });
        try {
            List<Future<long[]>> parts = new ArrayList<>();
            for (int worker = 0; worker < threads; worker++) {
                int first = worker;
                parts.add(workers.submit(() -> {
                    League league = player.onThread();
                    long[] counts = new long[numbers];
                    for (long chunk = (long) first * CHUNK; chunk < leagues; chunk += (long) threads * CHUNK) {
                        for (long number = chunk; number < Math.min(leagues, chunk + CHUNK); number++) {
                            league.play(number, counts);
                        }
                    }
                    return counts;
                }));
            }
            long[] all = new long[numbers];
            for (Future<long[]> part : parts) {
                long[] counts = part.get();
                for (int k = 0; k < numbers; k++) {
                    all[k] += counts[k];
                }
            }
            return all;
        } catch (ExecutionException problem) {
            throw new IllegalStateException("a made-up league", problem.getCause());
        } finally {
            workers.shutdownNow();
        }
    }
}
