package steward.league.play;

import java.util.ArrayDeque;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import steward.contest.WorkerThreads;

/**
 * Play on other machines: games of a run are sent there and their results taken. Games that belong together share a
 * thread while they are under way. A single thread waits for free places and for games: thousands of waiting threads,
 * each looking several times a second, would keep a processor busy.
 */
record RemotePlay(LeagueRun run, RemoteMachines remote) {

    /**
     * Plays until the run is over and all of its games here have ended.
     *
     * @throws Exception what a game failed with
     */
    Void play() throws Exception {
        ExecutorService threads = Executors.newCachedThreadPool(WorkerThreads.daemons("league"));
        Queue<Future<?>> games = new ArrayDeque<>();
        try {
            while (!run.isOver()) {
                while (!games.isEmpty() && games.peek().isDone()) {
                    games.remove().get();              // throws what has ended it
                }
                int most = remote.takePlace(LeagueRun.WAIT_MS);
                List<RemoteMachines.Game> next = most == 0 ? List.of() : run.take(most, remote::canPlay);
                if (most == 0) {
                    run.hasNoPlace();
                } else if (next.isEmpty()) {
                    remote.leavePlace();
                } else {
                    games.add(threads.submit(() -> play(next)));
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

    private Void play(List<RemoteMachines.Game> games) throws InterruptedException {
        try {
            run.play(games, remote::play);
            return null;
        } catch (RuntimeException problem) {
            run.stop("a game of another machine: " + problem);
            throw problem;
        } finally {
            remote.leavePlace();
        }
    }
}
