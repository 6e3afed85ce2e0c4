package steward.match;

import java.util.List;
import java.util.Map;

/**
 * Result of a match: ranks, scores and failures of the players, and how it ended.
 *
 * @param ending  one sentence without its full stop
 * @param players per player, in order
 * @param data    what bots reported about the match: {@code [TDATA] key = value} on stderr, the last value
 */
public record MatchResult(int turns, String ending, List<PlayerResult> players, Map<String, String> data) {

    public MatchResult {
        players = List.copyOf(players);
    }

    /** A result without data. */
    public MatchResult(int turns, String ending, List<PlayerResult> players) {
        this(turns, ending, players, Map.of());
    }

    /**
     * One player's part of the result.
     *
     * @param rank         0 for the best; ties share a rank
     * @param score        in the measure of the game, see {@link steward.game.Game#scores}
     * @param fault        how the player failed as a program (no answer in time, exit, invalid JSON, ...), or
     *                     {@code null}
     * @param out          why the player was eliminated, by a fault or by the rules, or {@code null}
     * @param answers      how many answers were requested
     * @param averageNanos mean answer time, in nanoseconds, the first answer left out when there are more
     * @param worstNanos   longest answer time, likewise
     * @param firstNanos   time of the first answer, which includes a process's start
     * @param earlyTurns   in how many turns there were lines beyond the answer; such lines wait for later turns
     * @param data         what the bot reported about itself on stderr: {@code [PDATA] key = value}, the last value,
     *                     and {@code [PDATA+] key = value}, the sum
     * @param heldFrom     the turn from which it was stopped while others were asked; 0 for never
     */
    public record PlayerResult(String name, int rank, double score, String fault, String out, int answers,
                               long averageNanos, long worstNanos, long firstNanos, int earlyTurns,
                               Map<String, String> data, int heldFrom) {

        /** A result of a player that was never held. */
        public PlayerResult(String name, int rank, double score, String fault, String out, int answers,
                            long averageNanos, long worstNanos, long firstNanos, int earlyTurns,
                            Map<String, String> data) {
            this(name, rank, score, fault, out, answers, averageNanos, worstNanos, firstNanos, earlyTurns, data, 0);
        }

        /** A result without data. */
        public PlayerResult(String name, int rank, double score, String fault, String out, int answers,
                            long averageNanos, long worstNanos, long firstNanos, int earlyTurns) {
            this(name, rank, score, fault, out, answers, averageNanos, worstNanos, firstNanos, earlyTurns, Map.of());
        }
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

    /**
     * True if there is no winner because those who share the first place all failed as programs: no draw of merit. So
     * ends a match whose players all fail in the same turn.
     */
    public boolean allFailed() {
        return winner() < 0 && players.stream().allMatch(player -> player.rank() != 0 || player.fault() != null);
    }

    /** True if any player failed as a program. */
    public boolean anyFault() {
        return players.stream().anyMatch(player -> player.fault() != null);
    }
}
