package steward.cli.replay;

import java.util.List;
import java.util.stream.IntStream;
import steward.cli.streams.Json;
import steward.replay.ReplayHeader;
import steward.text.TextFormat;

/**
 * Text of a replay's header for people: the beginning of each value, escaped for a terminal. The file may come from
 * anywhere, and a name in it may have a million letters.
 */
final class ReplayHeaderText {

    /** Characters of a name that are shown; a bot's name has at most as many. */
    private static final int LONGEST_NAME = 100;
    /** Characters of a command that are shown. */
    private static final int LONGEST_COMMAND = 1000;

    static String name(ReplayHeader header, int player) {
        return shown(header.names().get(player), LONGEST_NAME);
    }

    /** Of all players, in order. */
    static List<String> names(ReplayHeader header) {
        return IntStream.range(0, header.names().size()).mapToObj(player -> name(header, player)).toList();
    }

    static String bot(ReplayHeader header, int player) {
        return shown(header.bots().get(player), LONGEST_COMMAND);
    }

    static String scene(ReplayHeader header) {
        return shown(Json.word(Json.object(header.scene()).get("name"), 0), LONGEST_NAME);
    }

    static String game(ReplayHeader header) {
        return shown(header.game(), LONGEST_NAME);
    }

    private static String shown(String text, int most) {
        return TextFormat.plain(TextFormat.beginning(text, most));
    }
}
