package steward.league;

import java.util.Collections;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import steward.contest.repeat.GameFacts;
import steward.match.MatchResult;

/**
 * One game as the league's database stores it: an observation from which any rating can be computed.
 *
 * @param id       its number in the league; 0 before it is stored
 * @param name     see {@link GameName}
 * @param decision which decision of the schedule it belongs to, or -1 for none
 * @param attempt  counted from 1: of a game that was played again, all are stored
 * @param counts   whether it counts as played: neither was it played again, nor is it without a result, nor did a bot
 *                 burn in it that cannot be held
 * @param turns    how many were played
 * @param problem  why there is no result, or none that counts; or {@code null}
 * @param played   when it ended, in milliseconds since 1970
 * @param machine  on what it was played
 * @param replay   its file in the folder of replays, or {@code null}
 * @param transcript
 *                 digest of all commands and states, see {@link GameFacts}; 0 if it is not known
 * @param seats    one for each player, in order
 */
public record StoredGame(long id, byte[] name, int decision, long seed, int attempt, boolean counts, int turns,
                         String problem, long played, String machine, String replay, long transcript,
                         List<StoredSeat> seats) {

    /** The problem of a game begins so whose worker's answers are doubted, while nobody has decided. */
    public static final String SUSPENDED = "suspended: ";
    /** The problem of a game begins so that an operator has set aside, whatever it came to. */
    public static final String FORGIVEN = "forgiven";
    /** The problem of a forgiven game begins so that is played again. */
    public static final String FORGIVEN_AGAIN = "forgiven, played again: ";
    /** The problem of a further attempt begins so where an earlier one, which had been forgiven, counts again. */
    public static final String REPLACED = "forgiven: game ";
    /** The problem of a game begins so whose worker was caught; it is played again. */
    public static final String SET_ASIDE = "set aside: ";
    /** The problems of games that are played again, or were, begin so. */
    public static final List<String> AGAIN = List.of(FORGIVEN_AGAIN, REPLACED, SET_ASIDE);

    private static final Pattern VALUE = Pattern.compile("([A-Za-z]+)=(-?[0-9]+(?:\\.[0-9]+)?(?:E-?[0-9]+)?)");

    public StoredGame {
        seats = List.copyOf(seats);
    }

    /** By seat, whether the bot failed in this game; nothing if it does not count. */
    public boolean[] failed() {
        boolean[] failed = new boolean[counts ? seats.size() : 0];
        for (int seat = 0; seat < failed.length; seat++) {
            failed[seat] = seats.get(seat).fault() != null;
        }
        return failed;
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
     * @param values      the game's own, by name; empty if they are not known
     */
    public record StoredSeat(int version, int rank, double score, String fault, int answers, long meanNanos,
                             long worstNanos, long firstNanos, SortedMap<String, Double> values) {

        /** A player whose own values are not known. */
        public StoredSeat(int version, int rank, double score, String fault, int answers, long meanNanos,
                          long worstNanos, long firstNanos) {
            this(version, rank, score, fault, answers, meanNanos, worstNanos, firstNanos,
                Collections.emptySortedMap());
        }

        /** A player of a game that has been played. @param result {@code null} if it has none */
        public static StoredSeat of(int version, MatchResult result, int seat, SortedMap<String, Double> values) {
            if (result == null) {
                return new StoredSeat(version, 0, 0, null, 0, 0, 0, 0);
            }
            MatchResult.PlayerResult player = result.players().get(seat);
            return new StoredSeat(version, player.rank(), player.score(), player.fault(), player.answers(),
                player.averageNanos(), player.worstNanos(), player.firstNanos(), values);
        }

        /** The own values as a text: {@code laps=2.0}, apart by blanks; empty if they are not known. */
        public String valuesText() {
            return text(values);
        }

        /** Own values as {@link #valuesText} writes them. */
        public static String text(SortedMap<String, Double> values) {
            return values.entrySet().stream().map(value -> value.getKey() + "=" + value.getValue())
                .collect(Collectors.joining(" "));
        }

        /**
         * Reads own values.
         *
         * @param text as {@link #valuesText} writes them; {@code null} is empty
         * @throws IllegalArgumentException if it is something else
         */
        public static SortedMap<String, Double> values(String text) {
            SortedMap<String, Double> values = new TreeMap<>();
            for (String each : text == null || text.isEmpty() ? new String[0] : text.split(" ")) {
                Matcher value = VALUE.matcher(each);
                if (!value.matches() || values.put(value.group(1), Double.valueOf(value.group(2))) != null) {
                    throw new IllegalArgumentException("found '" + each + "', expected a name, = and a number");
                }
            }
            return values;
        }
    }

    /**
     * True if all of several players failed in the same turn: then nobody has earned the result, and no rating uses it.
     * Who failed was asked once for each turn up to the one in which it did.
     */
    public boolean allFailed() {
        return seats.size() > 1 && seats.stream().allMatch(seat -> seat.fault() != null
            && seat.answers() == seats.get(0).answers());
    }

    /** True if it is not played again: it counts, or there is a reason for its having no result. */
    public boolean isOver() {
        return counts || problem != null && AGAIN.stream().noneMatch(problem::startsWith);
    }

    /** True if ratings use it. */
    public boolean isRated() {
        return counts && !allFailed();
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
