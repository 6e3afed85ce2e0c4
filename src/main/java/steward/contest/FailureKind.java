package steward.contest;

import java.util.List;

/**
 * All failures of one bot for one reason in a series, the first of them in full.
 *
 * @param entrant     the bot, by its place in the call
 * @param occurrences where it failed so, in the order of the games; at least one
 * @param first       the first of them, with the last lines of stderr
 */
public record FailureKind(int entrant, List<Occurrence> occurrences, Failure first) {

    /**
     * One failure.
     *
     * @param turn in which the bot failed
     */
    public record Occurrence(Series.Played game, int turn) { }

    /** The game of the first. */
    public Series.Played game() {
        return occurrences.get(0).game();
    }
}
