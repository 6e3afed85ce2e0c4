package steward.machines.check;

import java.util.List;
import steward.contest.repeat.GameFacts;

/**
 * Result of a remote game, computed anew from its transcript.
 *
 * @param turns how many were played
 * @param facts what a result does not contain
 * @param seats one for each player
 * @param nanos that all answers took together
 */
public record CheckedGame(int turns, GameFacts facts, List<Seat> seats, long nanos) {

    public CheckedGame {
        seats = List.copyOf(seats);
    }

    /**
     * A player of a game.
     *
     * @param rank       0 for the best
     * @param score      the game's own
     * @param fault      how the bot failed, as failures of one kind are called; or {@code null}
     * @param answers    how many were requested
     * @param meanNanos  as it was measured there
     * @param worstNanos as it was measured there
     * @param firstNanos as it was measured there
     */
    public record Seat(int rank, double score, String fault, int answers, long meanNanos, long worstNanos,
                       long firstNanos) { }
}
