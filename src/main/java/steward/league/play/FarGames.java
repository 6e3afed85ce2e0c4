package steward.league.play;

import java.util.ArrayDeque;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;

/**
 * Plays the games of a run on other machines. Games that belong together share a thread while they are under way. A
 * single thread waits for free places and for games: thousands of waiting threads, each looking several times a second,
 * would keep a processor busy.
 */
record FarGames(Elsewhere elsewhere) {

    /** Run to which the games belong. */
    interface Run {

        /** True if no games are begun any more. */
        boolean isOver();

        /** Waits for games that belong together, at most so many; returns none at the end. */
        List<Elsewhere.Game> take(int most) throws InterruptedException;

        void play(List<Elsewhere.Game> games) throws InterruptedException;

        /** Notes that there is no place for games. */
        void waits() throws InterruptedException;

        /** Ends the run, because playing has thrown something. */
        void fail(RuntimeException problem);
    }

    /**
     * Plays until the run is over and all of its games here have ended.
     *
     * @throws Exception what a game failed with
     */
    Void play(Run run) throws Exception {
        ExecutorService threads = Executors.newCachedThreadPool(work -> {
            Thread thread = new Thread(work, "league");
            thread.setDaemon(true);
            return thread;
        });
        Queue<Future<?>> games = new ArrayDeque<>();
        try {
            while (!run.isOver()) {
                while (!games.isEmpty() && games.peek().isDone()) {
                    games.remove().get();              // throws what has ended it
                }
                int most = elsewhere.takePlace(LeagueRun.WAIT_MS);
                if (most == 0) {
                    run.waits();
                }
                List<Elsewhere.Game> next = most == 0 ? List.of() : run.take(most);
                if (!next.isEmpty()) {
                    games.add(threads.submit(() -> played(run, next)));
                } else if (most > 0) {
                    elsewhere.leavePlace();
                }
            }
            for (Future<?> one : games) {
                one.get();
            }
            return null;
        } catch (ExecutionException failed) {
            throw failed.getCause() instanceof Exception problem ? problem : failed;
        } finally {
            threads.shutdownNow();
        }
    }

    private Void played(Run run, List<Elsewhere.Game> games) throws InterruptedException {
        try {
            run.play(games);
            return null;
        } catch (RuntimeException problem) {
            run.fail(problem);
            throw problem;
        } finally {
            elsewhere.leavePlace();
        }
    }
}
