package steward.contest;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;

/** Policy for games that a bot lost on time while other programs or bots used the processors (see {@link Attempts}). */
public enum Hiccups {

    /** They are played again with the same seed. */
    REPLAY,
    /** They count. */
    COUNT;

    /** Returns the word as it is written in a call. */
    public String word() {
        return name().toLowerCase(Locale.ROOT);
    }

    public static Optional<Hiccups> of(String word) {
        return Arrays.stream(values()).filter(each -> each.word().equals(word)).findFirst();
    }
}
