package steward.match;

import java.util.List;

/**
 * How a match ended.
 *
 * @param turns   turns played
 * @param ending  one sentence without its full stop
 * @param players per player, in order
 */
public record MatchResult(int turns, String ending, List<PlayerResult> players) {

    /** Copies the list. */
    public MatchResult {
        players = List.copyOf(players);
    }

    /**
     * One player's part of the result.
     *
     * @param name         as shown to people
     * @param rank         0 for the best; ties share a rank
     * @param score        higher is better
     * @param fault        why the player failed as a program (no answer in time, exit, not JSON, ...), or {@code null}
     * @param out          why the player was eliminated, by a fault or by the rules, or {@code null}
     * @param answers      how many answers were waited for
     * @param averageNanos mean answer time, in nanoseconds, the first answer left out when there are more
     * @param worstNanos   longest answer time, likewise
     * @param firstNanos   time of the first answer, which includes a process's start
     * @param extraLines   most lines that were found waiting beyond an answer
     */
    public record PlayerResult(String name, int rank, double score, String fault, String out, int answers,
                               long averageNanos, long worstNanos, long firstNanos, int extraLines) {
    }

    /** The only player of rank 0, or -1 for a draw. */
    public int winner() {
        int winner = -1;
        for (int player = 0; player < players.size(); player++) {
            if (players.get(player).rank() == 0) {
                if (winner >= 0) {
                    return -1;
                }
                winner = player;
            }
        }
        return winner;
    }

    /** Whether any player failed as a program. */
    public boolean anyFault() {
        return players.stream().anyMatch(player -> player.fault() != null);
    }
}
