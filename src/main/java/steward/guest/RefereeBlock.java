package steward.guest;

import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * A block of lines, {@code [[NAME] n]} followed by n lines: the unit of all communication between a referee and its
 * host.
 *
 * @param lines behind its head, without line ends
 */
record RefereeBlock(Name name, List<String> lines) {

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
        /** Said by a JVM of {@link GuestJvm} between two games. */
        READY;

        /** True if the host speaks next. */
        boolean isLast() {
            return this == NEXT_PLAYER_INFO || this == SCORES || this == FAIL || this == READY;
        }
    }

    /** Head of a block as a referee writes it: its name and its number of lines. */
    static final Pattern HEAD = Pattern.compile("\\[\\[(" + Stream.of(Name.values()).map(Name::name)
        .collect(Collectors.joining("|")) + ")\\] ?(\\d{1,9})\\]");

    RefereeBlock {
        lines = List.copyOf(lines);
    }

    /** Returns a block as a host says it. */
    static String text(String name, List<String> lines) {
        return "[[" + name + "] " + lines.size() + "]\n" + lines.stream().map(line -> line + "\n")
            .collect(Collectors.joining());
    }
}
