package steward.machines.serve;

import java.util.HashMap;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import steward.machines.wire.GameJob;

/**
 * Number of games that are sent to a worker in one job: as many as take half a second, by the slowest bots. A job costs
 * the broker as much as a short game costs a worker. Thread-safe.
 */
final class JobSize {

    /** How long the games of a job should take together, in nanoseconds. */
    private static final long JOB_NANOS = TimeUnit.MILLISECONDS.toNanos(500);
    /** By how much of the difference a job moves the mean time of a game. */
    private static final double MOVE = 0.125;

    /** How long each worker has a game, on average, in nanoseconds. */
    private final Map<String, Double> means = new HashMap<>();

    /** A worker has played games of a job in so many nanoseconds. */
    synchronized void played(String worker, int games, long nanos) {
        double each = (double) nanos / games;
        means.merge(worker, each, (mean, now) -> mean + MOVE * (now - mean));
    }

    /** A worker plays no more, or begins anew. */
    synchronized void forget(String worker) {
        means.remove(worker);
    }

    /** Returns how many games should go together, from 1 to so many; 1 if nothing is known. */
    synchronized int games(int most) {
        double slowest = means.values().stream().mapToDouble(mean -> mean).max().orElse(Double.POSITIVE_INFINITY);
        return (int) Math.max(1, Math.min(Math.min(most, GameJob.MOST_GAMES), JOB_NANOS / Math.max(1, slowest)));
    }
}
