package steward.replay.page;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.StringJoiner;
import steward.bot.ErrorLine;
import steward.bot.FaultMessages;
import steward.game.GameTypes;
import steward.replay.RecordedTurn;
import steward.replay.ReplayReader;

/**
 * Details of a match on its page besides the replay, for people who look for a fault. It is lines of UTF-8. The first
 * is a JSON array with one {@code [turn, player, line]} for each bot that failed: {@code line}, counted from 0, is the
 * line of stderr in that turn that tells why. The other lines are those of {@link SentFrames}; none if these are not
 * known.
 */
final class PageDetails {

    private PageDetails() { }

    /** @param types games with which the match is played again; {@code null} for no frames */
    static byte[] of(byte[] replay, String source, GameTypes types) {
        ByteArrayOutputStream details = new ByteArrayOutputStream();
        details.writeBytes((errors(replay, source) + "\n").getBytes(StandardCharsets.UTF_8));
        byte[] sent = types == null ? null : SentFrames.of(replay, source, types);
        if (sent != null) {
            details.writeBytes(sent);
        }
        return details.toByteArray();
    }

    private static String errors(byte[] replay, String source) {
        StringJoiner errors = new StringJoiner(",", "[", "]");
        if (replay.length == 0) {
            return errors.toString();              // it was cut off in its header
        }
        try (ReplayReader reader = new ReplayReader(new ByteArrayInputStream(replay), source)) {
            for (RecordedTurn turn = reader.next(); turn != null; turn = reader.next()) {
                for (int player = 0; player < turn.faults().length; player++) {
                    int line = line(turn.faults()[player], turn.stderr()[player]);
                    if (line >= 0) {
                        errors.add("[" + turn.number() + "," + player + "," + line + "]");
                    }
                }
            }
        }
        return errors.toString();
    }

    /** If no line has a known form, it is the last one of a program that ended, and none of one that went on. */
    private static int line(String fault, String stderr) {
        if (fault == null || stderr == null) {
            return -1;
        }
        List<String> lines = stderr.lines().toList();
        int line = ErrorLine.index(lines);
        for (int last = lines.size() - 1; line < 0 && last >= 0 && FaultMessages.isExit(fault); last--) {
            line = lines.get(last).isBlank() ? line : last;
        }
        return line;
    }
}
