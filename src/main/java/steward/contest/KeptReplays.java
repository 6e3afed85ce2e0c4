package steward.contest;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;

/** Setting for which replays of a series are kept. */
public enum KeptReplays {

    /** Every one; also that of a game that was broken off, if it has a turn. */
    ALL,
    /** Games that the first bot of the call has lost. */
    LOST,
    /** Games in which any bot failed, and games without a result. */
    FAILED,
    /** Not one; nothing is recorded. */
    NONE;

    /** Returns the word as it is written in a call. */
    public String word() {
        return name().toLowerCase(Locale.ROOT);
    }

    public static Optional<KeptReplays> of(String word) {
        return Arrays.stream(values()).filter(each -> each.word().equals(word)).findFirst();
    }

    boolean keeps(Contest contest, Series.Played game) {
        return switch (this) {
            case ALL -> true;
            case LOST -> game.result() != null && game.result().players().get(game.playerOf(contest, 0)).rank() > 0;
            case FAILED -> game.result() == null || game.result().anyFault();
            case NONE -> false;
        };
    }
}
