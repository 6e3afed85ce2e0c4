package steward.contest.repeat;

import java.util.HashSet;
import java.util.Set;
import steward.numerics.StateHash;

/**
 * Detector of games that repeat an earlier one, so that equal games count once. Games of the same players in the same
 * seats with the same transcript are one observation, whatever their seeds were. Not thread-safe.
 */
public final class Repeats {

    /** Repeats in a row after which nothing new is expected. */
    public static final int ENOUGH = 20;

    private final Set<Long> seen = new HashSet<>();
    private long repeats;

    /**
     * Adds a game.
     *
     * @param players    number of the players in their seats
     * @param transcript see {@link GameFacts}; a game of which it is not known is no repeat
     * @return true if there was an equal one before
     */
    public boolean isRepeat(long players, long transcript) {
        boolean repeat = transcript != 0 && !seen.add(new StateHash().add(players).add(transcript).value());
        repeats += repeat ? 1 : 0;
        return repeat;
    }

    /** Games that were repeats. */
    public long count() {
        return repeats;
    }
}
