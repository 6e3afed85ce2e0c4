package steward.league.play;

import java.util.ArrayDeque;
import java.util.Queue;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.function.BooleanSupplier;

/**
 * The games of a run that other machines play. Those that go together have a thread while they are under way. There are
 * no threads that wait for a place to be free: thousands of them, looking several times a second, would keep a
 * processor busy.
 */
record FarGames(Elsewhere elsewhere) {

    /** Plays the next games, at most so many, which go together. */
    interface Player {
        /** @return whether there may be more */
        boolean play(int most) throws Exception;
    }

    /**
     * Plays until the run is over and all of these games are.
     *
     * @throws Exception what a game failed with
     */
    Void play(BooleanSupplier over, Player player) throws Exception {
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
                int together = elsewhere.takePlace(LeagueRun.WAIT_MS);
                if (together > 0) {
                    games.add(threads.submit(() -> {
                        try {
                            return player.play(together);
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
