package steward.guest;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.regex.Pattern;
import steward.game.TextCodec;

/** Lines between a guest's referee and the bots, passed on as they are. */
record GuestText(GuestGame game) implements TextCodec {

    /** Characters at which readers of some languages end a line. */
    private static final Pattern ENDS = Pattern.compile("[\\n\\r\\x0b\\x0c\\x1c-\\x1e\\x85\\u2028\\u2029]");

    @Override
    public void writeSetup(StringBuilder out, int player) {
        // The referee itself sends what bots get first, with its first question.
    }

    @Override
    public void writeTurn(StringBuilder out, int player) {
        out.append(game.input(player));
    }

    @Override
    public int answerLines(int player) {
        return game.lines();
    }

    @Override
    public String readAnswer(int player, byte[] answer, int length) {
        List<String> lines = List.of(new String(answer, 0, length, StandardCharsets.UTF_8).split("\n", -1));
        if (lines.size() != game.lines()) {
            return "found " + lines.size() + " lines, expected " + game.lines();
        }
        String wrong = wrong(lines);
        if (wrong == null) {
            game.answer(lines, game.answerMs());
        }
        return wrong;
    }

    /** Returns what is wrong with an answer whose lines a referee could take for more than there are, or null. */
    static String wrong(List<String> lines) {
        return lines.stream().anyMatch(line -> ENDS.matcher(line).find())
            ? "found an end of line within a line, expected none" : null;
    }

    @Override
    public String message(int player) {
        return null;
    }
}
