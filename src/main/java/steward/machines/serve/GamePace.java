package steward.machines.serve;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import steward.league.StoredGame;
import steward.league.StoredGame.StoredSeat;
import steward.league.play.RemoteMachines;

/**
 * Estimate of how long a game takes, and so of when to give a worker's game to others. A worker that keeps games must
 * not stop the schedule, which waits for its oldest games. Each time a game is taken away, its time is doubled.
 * Thread-safe.
 */
final class GamePace {

    /** Time for what is not a bot's: its bundle, its trial, the start of processes, on a busy machine. */
    private static final long START_NANOS = TimeUnit.SECONDS.toNanos(10);
    /** How much slower a worker may be than the games before. */
    private static final double SLOWER = 8;
    /** Part of the patience that is left when a thread of the league has nothing else to play. */
    private static final double HURRY = 0.25;
    /** Share of the difference by which a game moves a bot's mean. */
    private static final double MOVE = 0.125;

    private final long lease;
    /** Mean time of each version in a game, in nanoseconds. */
    private final Map<Integer, Double> means = new HashMap<>();
    private final Map<Long, Integer> ended = new HashMap<>();

    /** @param lease the longest time, in nanoseconds */
    GamePace(long lease) {
        this.lease = lease;
    }

    /** Adds a game that was played, by whomever. */
    synchronized void played(StoredGame game) {
        for (StoredSeat seat : game.seats()) {
            means.merge(seat.version(), (double) seat.meanNanos() * seat.answers(),
                (mean, now) -> mean + MOVE * (now - mean));
        }
        ended.remove(game.seed());
    }

    /**
     * Returns how long a worker may keep these games, in nanoseconds: the lease if a bot has not played yet.
     *
     * @param hurry true for the time after which somebody else plays them who has nothing else to play
     */
    synchronized long patience(List<RemoteMachines.Game> games, boolean hurry) {
        double sum = 0;
        int doublings = 0;
        for (RemoteMachines.Game game : games) {
            sum += game.members().stream().mapToDouble(member ->
                means.getOrDefault(member.version().id(), Double.POSITIVE_INFINITY)).sum();
            doublings = Math.max(doublings, ended.getOrDefault(game.task().seed(), 0));
        }
        return (long) ((hurry ? HURRY : 1) * Math.min(lease, (START_NANOS + SLOWER * sum) * (1L << doublings)));
    }

    /** Notes that these games were taken away. */
    synchronized void ended(List<RemoteMachines.Game> games) {
        games.forEach(game -> ended.merge(game.task().seed(), 1, (before, one) -> Math.min(20, before + one)));
    }
}
