package steward.game;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import steward.text.TextFormat;

/**
 * Base class of line protocols in which a player answers with one line for each of its bodies: a command, then a
 * message.
 */
public abstract class CommandLines implements TextCodec {

    private static final int SHOWN = 40;

    private final String[] messages;

    /** Lines for a game of so many players. */
    protected CommandLines(int players) {
        messages = new String[players];
    }

    /**
     * Reads a line and makes it the command of one of the player's bodies.
     *
     * @param line as it came, perhaps with a carriage return at its end
     * @param said takes the message, see {@link #say}
     * @return what is wrong, or {@code null}
     */
    protected abstract String read(String line, int player, int index, List<String> said);

    /** Adds a message, unless it is {@code null}. */
    protected static void say(String message, List<String> said) {
        if (message != null) {
            said.add(message);
        }
    }

    /** A line without the carriage return at its end. */
    protected static String withoutReturn(String line) {
        return line.endsWith("\r") ? line.substring(0, line.length() - 1) : line;
    }

    /** Returns the error of a text that is no command. @param expected what it may hold */
    protected static String notFound(String expected, String text) {
        return "found \"" + TextFormat.beginning(text, SHOWN) + "\", expected " + expected;
    }

    @Override
    public String readAnswer(int player, byte[] answer, int length) {
        messages[player] = null;
        String[] lines = new String(answer, 0, length, StandardCharsets.UTF_8).split("\n", -1);
        if (lines.length != answerLines(player)) {
            return "found " + lines.length + " lines, expected " + answerLines(player);
        }
        List<String> said = new ArrayList<>();
        for (int k = 0; k < lines.length; k++) {
            String wrong = read(lines[k], player, k, said);
            if (wrong != null) {
                return "line " + (k + 1) + " of " + lines.length + ": " + wrong;
            }
        }
        messages[player] = said.isEmpty() ? null : String.join(" | ", said);
        return null;
    }

    @Override
    public String message(int player) {
        return messages[player];
    }
}
