package steward.codingame;

import java.util.List;
import steward.match.MatchResult;
import steward.match.MatchResult.PlayerResult;

/**
 * Scores in the form that arena tools compare: whole numbers, higher is better, negative for a player that failed. They
 * follow the ranks: a better rank always has the higher score, and a shared rank the same score.
 */
public final class GameResultScores {

    private GameResultScores() { }

    /**
     * Per player. Ahead of all players that failed as programs, a score is the number of players behind; from the best
     * failed player on, ranks are counted down from -1. (A player ranked with or behind a player that failed has been
     * eliminated as well.)
     */
    public static int[] of(MatchResult result) {
        List<PlayerResult> players = result.players();
        int failed = players.stream().filter(player -> player.fault() != null).mapToInt(PlayerResult::rank).min()
            .orElse(Integer.MAX_VALUE);
        return players.stream().mapToInt(PlayerResult::rank)
            .map(rank -> rank < failed ? behind(players, rank) : -1 - ranksBetween(players, failed, rank))
            .toArray();
    }

    private static int behind(List<PlayerResult> players, int rank) {
        return (int) players.stream().filter(player -> player.rank() > rank).count();
    }

    private static int ranksBetween(List<PlayerResult> players, int from, int to) {
        return (int) players.stream().mapToInt(PlayerResult::rank).filter(rank -> rank >= from && rank < to).distinct()
            .count();
    }
}
