package steward.guest;

import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A block of lines, {@code [[NAME] n]} and n lines behind it: all that a referee and its host say to each other.
 *
 * @param name  of the block
 * @param lines behind its head, without line ends
 */
record Block(Name name, List<String> lines) {

    /** The names of blocks that a referee says. */
    enum Name {
        /** Picture of the game for a viewer. */
        VIEW,
        /** Number of the frame, and who is named in it. */
        INFOS,
        /** Text for people about the turn. */
        SUMMARY,
        /** Pairs of lines: text for people about a moment, and the number of its player. */
        TOOLTIP,
        /** Answers are to be told with their time from now on. */
        MONITORING,
        /** Lines for the player that is asked next. */
        NEXT_PLAYER_INPUT,
        /** Player that is asked, its lines and its limit in milliseconds; ends the referee's turn to speak. */
        NEXT_PLAYER_INFO,
        /** Parameters of the game at its end, from which it could be played again. */
        UINPUT,
        /** Values at the end for those who evaluate games. */
        METADATA,
        /** End of the game: a line with player and score for each player. */
        SCORES,
        /** End of the game by an exception of the referee. */
        FAIL,
        /** Said by a JVM of {@link RefereeHost} between two games. */
        READY;

        /** True if the host speaks next. */
        boolean isLast() {
            return this == NEXT_PLAYER_INFO || this == SCORES || this == FAIL || this == READY;
        }
    }

    private static final Pattern HEAD = Pattern.compile("\\[\\[([A-Z_]{1,30})\\] ?(\\d{1,9})\\]");

    /** Copies the list. */
    Block {
        lines = List.copyOf(lines);
    }

    /** Head of a block as a referee writes it; its number of lines is that of the match. */
    record Head(Name name, int lines) {
    }

    /** The head that a line is, if it is one. */
    static Optional<Head> head(String line) {
        Matcher head = HEAD.matcher(line);
        if (!head.matches()) {
            return Optional.empty();
        }
        for (Name name : Name.values()) {
            if (name.name().equals(head.group(1))) {
                return Optional.of(new Head(name, Integer.parseInt(head.group(2))));
            }
        }
        return Optional.empty();
    }

    /** Appends a block as a host says it. */
    static void write(StringBuilder out, String name, List<String> lines) {
        out.append("[[").append(name).append("] ").append(lines.size()).append("]\n");
        lines.forEach(line -> out.append(line).append('\n'));
    }
}
