package steward.guest;

import java.nio.charset.StandardCharsets;
import java.util.List;
import steward.game.TextCodec;

/** Line protocol between a guest's referee and the bots, whose lines pass unchanged. */
record GuestText(GuestGame game) implements TextCodec {

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
        return game.refusal(List.of(new String(answer, 0, length, StandardCharsets.UTF_8).split("\n", -1)),
            game.answerMs());
    }

    @Override
    public String message(int player) {
        return null;
    }
}
