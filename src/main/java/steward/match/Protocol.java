package steward.match;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;

/** The languages a bot can speak. */
public enum Protocol {
    /** One JSON object a line: setup, turn, answer, end. */
    JSON,
    /** CodinGame's lines of words and numbers, where the scene's game has them. */
    CODINGAME;

    /** The protocol of a word, if there is one. */
    public static Optional<Protocol> of(String word) {
        return Arrays.stream(values()).filter(protocol -> protocol.word().equals(word)).findFirst();
    }

    /** As it is written on the command line and in replays: lower case. */
    public String word() {
        return name().toLowerCase(Locale.ROOT);
    }
}
