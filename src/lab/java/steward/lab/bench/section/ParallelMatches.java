package steward.lab.bench.section;

import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import steward.match.MatchListener;
import steward.match.MatchResult;
import steward.numerics.StateHash;

/** Many matches on several threads. */
public final class ParallelMatches {

    private static final MatchListener NO_LISTENER = new MatchListener() { };

    private ParallelMatches() { }

    /**
     * Plays the matches with the seeds 0, 1, ... between bots that read the game itself.
     *
     * @return a hash of all results, in the order of seeds
     */
    public static long play(MatchFixture fixture, int games, int threads) throws InterruptedException {
        long[] results = new long[games];
        AtomicInteger next = new AtomicInteger();
        AtomicReference<RuntimeException> failure = new AtomicReference<>();
        Runnable work = () -> {
            try {
                for (int game = next.getAndIncrement(); game < games; game = next.getAndIncrement()) {
                    results[game] = result(
                        MatchSection.match(fixture, MatchSection.direct(fixture), game, NO_LISTENER));
                }
            } catch (RuntimeException failed) {
                failure.compareAndSet(null, failed);
            }
        };
        Thread[] workers = new Thread[threads];
        for (int k = 0; k < threads; k++) {
            workers[k] = new Thread(work, "bench-" + k);
            workers[k].setDaemon(true);
            workers[k].start();
        }
        for (Thread worker : workers) {
            worker.join();
        }
        if (failure.get() != null) {
            throw failure.get();
        }
        StateHash hash = new StateHash();
        for (long result : results) {
            hash.add(result);
        }
        return hash.value();
    }

    private static long result(MatchResult result) {
        StateHash hash = new StateHash().add(result.turns());
        for (MatchResult.PlayerResult player : result.players()) {
            hash.add(player.rank()).add(player.score());
        }
        return hash.value();
    }
}
