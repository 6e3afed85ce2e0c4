package steward.replay.page;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import steward.bot.LineBuffer;
import steward.game.GameTypes;
import steward.replay.JsonLine;
import steward.replay.RecordedTurn;
import steward.replay.ReplayReader;
import steward.replay.feed.SentLines;
import tools.jackson.core.io.JsonStringEncoder;

/**
 * Frames that all bots of a match were sent, for its page. They are not recorded: the game is played again and gives
 * them, as long as it agrees with the recording. All else on the page is drawn from recorded states. A match without
 * bots, or with so many bodies that playing it takes long, is not played again.
 */
final class SentFrames {

    /** Characters of frames that a page holds at most: it is still opened in a moment. */
    private static final int MOST = 24 << 20;
    /** Bodies at the start up to which a match is played again: twice as many as in any game of the site. */
    private static final int MOST_BODIES = 100;

    /**
     * Returns UTF-8 text of one line per turn, from turn 0 on: a JSON array with the lines that each player was sent,
     * as one string or {@code null}. Returns {@code null} if the match is not played again, or cannot be.
     */
    static byte[] of(byte[] replay, String source, GameTypes types) {
        try (ReplayReader reader = new ReplayReader(new ByteArrayInputStream(replay), source)) {
            return reader.header().names().isEmpty() || bodies(reader.start()) > MOST_BODIES ? null
                : lines(reader, types).getBytes(StandardCharsets.UTF_8);
        } catch (RuntimeException cannotBePlayedAgain) {
            return null;                 // an import without its commands, a game that is not installed, an older law
        }
    }

    private static int bodies(byte[] start) {
        JsonLine state = new JsonLine("state", new JsonLine("start", start).object("state"));
        return state.has("bodies") ? state.objects("bodies").size() : 0;
    }

    private static String lines(ReplayReader replay, GameTypes types) {
        SentLines frames = new SentLines(replay, types);
        int players = replay.header().names().size();
        StringBuilder lines = new StringBuilder("[");
        for (int player = 0; player < players; player++) {
            append(lines, player, frames.setup(player));
        }
        lines.append("]\n");
        for (RecordedTurn turn = replay.next(); turn != null && lines.length() < MOST; turn = replay.next()) {
            lines.append('[');
            for (int player = 0; player < players; player++) {
                append(lines, player, frames.turn(player, turn));
            }
            lines.append("]\n");
            if (frames.match().play(turn) != null) {
                break;
            }
        }
        return lines.toString();
    }

    private static void append(StringBuilder lines, int player, LineBuffer frame) {
        lines.append(player == 0 ? "" : ",");
        if (frame == null) {
            lines.append("null");
        } else {
            String text = new String(frame.bytes(), 0, frame.size(), StandardCharsets.UTF_8).stripTrailing();
            lines.append('"').append(JsonStringEncoder.getInstance().quoteAsCharArray(text)).append('"');
        }
    }
}
