package steward.match;

import java.util.Locale;

/** The languages a bot can speak. */
public enum Protocol {
    /** One JSON object a line: setup, turn, answer, end. */
    JSON,
    /** CodinGame's lines of words and numbers, where the scene's game has them. */
    CODINGAME;

    /** As it is written on the command line and in replays: lower case. */
    public String word() {
        return name().toLowerCase(Locale.ROOT);
    }
}
