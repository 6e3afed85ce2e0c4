package steward.match;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;

/** Protocols that a bot can use: JSON frames, or the game's text lines. */
public enum Protocol {
    /** One JSON object a line: setup, turn, answer, end. */
    JSON,
    /** CodinGame's lines of words and numbers, if the scene's game has them. */
    CODINGAME;

    public static Optional<Protocol> of(String word) {
        return Arrays.stream(values()).filter(protocol -> protocol.word().equals(word)).findFirst();
    }

    /** The name on the command line and in replays: lower case. */
    public String word() {
        return name().toLowerCase(Locale.ROOT);
    }
}
