package steward.replay.page;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import steward.bot.LineBuffer;
import steward.game.GameTypes;
import steward.replay.RecordedTurn;
import steward.replay.ReplayReader;
import steward.replay.feed.SentLines;
import tools.jackson.core.io.JsonStringEncoder;

/**
 * Frames that all bots of a match were sent, for its page. They are not recorded: the game is played again and gives
 * them, as long as it agrees with the recording.
 */
final class SentFrames {

    /** Characters of frames that a page holds at most: it is still opened in a moment. */
    private static final int MOST = 24 << 20;

    /**
     * Returns UTF-8 text of one line per turn, from turn 0 on: a JSON array with the lines that each player was sent,
     * as one string or {@code null}. Returns {@code null} if the match cannot be played again.
     */
    static byte[] of(byte[] replay, String source, GameTypes types) {
        try (ReplayReader reader = new ReplayReader(new ByteArrayInputStream(replay), source)) {
            return lines(reader, types).getBytes(StandardCharsets.UTF_8);
        } catch (RuntimeException cannotBePlayedAgain) {
            return null;                 // an import without its commands, a game that is not installed, an older law
        }
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
