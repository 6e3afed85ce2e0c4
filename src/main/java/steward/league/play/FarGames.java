package steward.league.play;

import java.util.ArrayDeque;
import java.util.Queue;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.function.BooleanSupplier;

/**
 * The games of a run that other machines play. Each has a thread while it is under way. There are no threads that wait
 * for a place to be free: thousands of them, looking several times a second, would keep a processor busy.
 */
record FarGames(Elsewhere elsewhere) {

    /**
     * Plays until the run is over and all of these games are.
     *
     * @param game plays the next one
     * @throws Exception what a game failed with
     */
    Void play(BooleanSupplier over, Callable<Boolean> game) throws Exception {
        ExecutorService threads = Executors.newCachedThreadPool(work -> {
            Thread thread = new Thread(work, "league");
            thread.setDaemon(true);
            return thread;
        });
        Queue<Future<Boolean>> games = new ArrayDeque<>();
        try {
            while (!over.getAsBoolean()) {
                while (!games.isEmpty() && games.peek().isDone()) {
                    games.remove().get();              // throws what has ended it
                }
                if (elsewhere.takePlace(LeagueRun.WAIT_MS)) {
                    games.add(threads.submit(() -> {
                        try {
                            return game.call();
                        } finally {
                            elsewhere.leavePlace();
                        }
                    }));
                }
            }
            for (Future<Boolean> one : games) {
                one.get();
            }
            return null;
        } catch (ExecutionException failed) {
            throw failed.getCause() instanceof Exception problem ? problem : failed;
        } finally {
            threads.shutdownNow();
        }
    }
}
