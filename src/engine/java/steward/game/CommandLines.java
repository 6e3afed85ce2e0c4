package steward.game;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import steward.text.TextFormat;

/** Lines of a game in which a player answers with a line for each of its bodies, a command with a message behind it. */
public abstract class CommandLines<C> implements TextCodec {

    private static final int SHOWN = 40;

    private final String[] messages;
    private final String expected;

    /**
     * Lines for a game of so many players.
     *
     * @param expected what a line may hold, for an error
     */
    protected CommandLines(int players, String expected) {
        messages = new String[players];
        this.expected = expected;
    }

    /**
     * Reads a line.
     *
     * @param said takes the message, see {@link #say}
     * @return {@code null} if the line is no command
     */
    protected abstract C read(String line, int player, int index, List<String> said);

    /** Makes a command the body's. @return why it is refused, or {@code null} */
    protected abstract String command(int player, int index, C command);

    /** Adds a message, unless it is {@code null}. */
    protected static void say(String message, List<String> said) {
        if (message != null) {
            said.add(message);
        }
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
            String line = lines[k].endsWith("\r") ? lines[k].substring(0, lines[k].length() - 1) : lines[k];
            C command = read(line, player, k, said);
            String refusal = command == null
                ? "found \"" + TextFormat.beginning(line, SHOWN) + "\", expected " + expected
                : command(player, k, command);
            if (refusal != null) {
                return "line " + (k + 1) + " of " + lines.length + ": " + refusal;
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
