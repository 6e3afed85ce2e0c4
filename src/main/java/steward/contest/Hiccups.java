package steward.contest;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import steward.bot.TimeSpent;

/** What becomes of a game that a bot lost on time while other programs used the processors. */
public enum Hiccups {

    /** It is played again, once, with the same seed; the second game counts, however it ends. */
    REPLAY,
    /** It counts. */
    COUNT;

    /** As it is written in a call. */
    public String word() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** By its {@link #word}. */
    public static Optional<Hiccups> of(String word) {
        return Arrays.stream(values()).filter(each -> each.word().equals(word)).findFirst();
    }

    /** Whether a game that is over is to be played again: a bot was late, and {@link TimeSpent#starved}. */
    boolean demandAnother(Series.Played game) {
        return this == REPLAY && game.result() != null && game.starved() == null
            && game.failures().stream().anyMatch(Failure::starved);
    }
}
