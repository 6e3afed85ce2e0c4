package steward.replay.page;

import java.nio.charset.StandardCharsets;
import java.util.function.IntPredicate;

/**
 * Copy of a replay without the stderr and command lines of other players' bots, for readers who may see only their own.
 * Hashes and signature stay unchanged: the copy is for watching, not for verifying.
 */
final class OwnStderr {

    private static final String FIELD = ",\"stderr\":[";
    private static final String BOT = "\"bot\":";

    private OwnStderr() { }

    /** @param isShown whether a player's stderr and command stay */
    static byte[] of(byte[] replay, IntPredicate isShown) {
        StringBuilder lines = new StringBuilder();
        boolean header = true;
        for (String line : new String(replay, StandardCharsets.UTF_8).split("(?<=\n)")) {
            lines.append(header ? header(line, isShown) : turn(line, isShown));
            header = false;
        }
        return lines.toString().getBytes(StandardCharsets.UTF_8);
    }

    /** The commands stand before the scene, one for each player. */
    private static String header(String line, IntPredicate isShown) {
        int scene = line.indexOf("\"scene\":");
        StringBuilder kept = new StringBuilder();
        int from = 0;
        int player = 0;
        for (int at = line.indexOf(BOT); at >= 0 && at < scene; at = line.indexOf(BOT, from)) {
            int value = at + BOT.length();
            int end = end(line, value);
            kept.append(line, from, value).append(isShown.test(player++) ? line.substring(value, end) : "\"-\"");
            from = end;
        }
        return kept.append(line.substring(from)).toString();
    }

    /** No text within a line has the field's quotes unescaped, and the field is behind the game's own. */
    private static String turn(String line, IntPredicate isShown) {
        int begin = line.lastIndexOf(FIELD);
        if (begin < 0) {
            return line;
        }
        int at = begin + FIELD.length();
        StringBuilder kept = new StringBuilder(line.substring(0, at));
        for (int player = 0; line.charAt(at) != ']'; player++) {
            if (line.charAt(at) == ',') {
                kept.append(',');
                at++;
            }
            int end = end(line, at);
            kept.append(isShown.test(player) ? line.substring(at, end) : "null");
            at = end;
        }
        return kept.append(line.substring(at)).toString();
    }

    /** End of a text in quotes, or of {@code null}. */
    private static int end(String line, int begin) {
        if (line.charAt(begin) != '"') {
            return begin + "null".length();
        }
        int at = begin + 1;
        while (line.charAt(at) != '"') {
            at += line.charAt(at) == '\\' ? 2 : 1;
        }
        return at + 1;
    }
}
