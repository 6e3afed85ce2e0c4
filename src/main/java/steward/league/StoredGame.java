package steward.league;

import java.util.List;
import java.util.stream.Collectors;

/**
 * One game as it is stored: an observation that any rating can be computed from.
 *
 * @param id       its number in the league; 0 before it is stored
 * @param name     see {@link GameName}
 * @param decision which decision of the schedule it belongs to, or -1 for none
 * @param seed     its seed
 * @param attempt  1, or 2 if it was played again
 * @param counts   whether it counts: neither was it played again, nor is it without a result
 * @param turns    how many were played
 * @param problem  why there is no result, or {@code null}
 * @param played   when it ended, in milliseconds since 1970
 * @param machine  on what it was played
 * @param replay   its file in the folder of replays, or {@code null}
 * @param seats    one for each player, in order
 */
public record StoredGame(long id, byte[] name, int decision, long seed, int attempt, boolean counts, int turns,
                         String problem, long played, String machine, String replay, List<StoredSeat> seats) {

    /** Copies the list. */
    public StoredGame {
        seats = List.copyOf(seats);
    }

    /**
     * One player of a game.
     *
     * @param version     of which bot
     * @param rank        0 for the best; ties share a rank
     * @param score       the game's own
     * @param fault       how the bot failed, or {@code null}
     * @param answers     how many were requested
     * @param meanNanos   mean answer time
     * @param worstNanos  the longest
     * @param firstNanos  that of the first answer
     */
    public record StoredSeat(int version, int rank, double score, String fault, int answers, long meanNanos,
                             long worstNanos, long firstNanos) {
    }

    /** The versions in the order of seats. */
    public int[] lineup() {
        return seats.stream().mapToInt(StoredSeat::version).toArray();
    }

    /** The ranks in the order of seats, apart by blanks. */
    public String ranks() {
        return seats.stream().map(seat -> Integer.toString(seat.rank())).collect(Collectors.joining(" "));
    }
}
