package steward.game;

import java.nio.charset.StandardCharsets;

/** Text of codecs: lines and frames that they write, answers that they read. */
public final class CodecText {

    private CodecText() {
    }

    /** Lines before the first turn. */
    public static String setup(TextCodec lines, int player) {
        StringBuilder out = new StringBuilder();
        lines.writeSetup(out, player);
        return out.toString();
    }

    /** Lines of a turn. */
    public static String turn(TextCodec lines, int player) {
        StringBuilder out = new StringBuilder();
        lines.writeTurn(out, player);
        return out.toString();
    }

    /** Reads lines. @return what is wrong, or {@code null} */
    public static String read(TextCodec lines, int player, String answer) {
        byte[] bytes = answer.getBytes(StandardCharsets.UTF_8);
        return lines.readAnswer(player, bytes, bytes.length);
    }

    /** Reads a line of JSON. @return what is wrong, or {@code null} */
    public static String read(GameJson frames, int player, String answer) {
        byte[] bytes = answer.getBytes(StandardCharsets.UTF_8);
        return frames.readAnswer(player, bytes, bytes.length);
    }
}
