package steward.match;

import java.nio.charset.StandardCharsets;
import steward.bot.LineBuffer;
import steward.game.TextCodec;

/** Dialogue in a game's line protocol, which sends nothing at the end of a game. */
final class TextDialogue implements Dialogue {

    private final TextCodec codec;
    private final StringBuilder text = new StringBuilder();
    private final LineBuffer buffer = new LineBuffer();

    TextDialogue(TextCodec codec) {
        this.codec = codec;
    }

    @Override
    public LineBuffer setup(int player) {
        text.setLength(0);
        codec.writeSetup(text, player);
        return bytes();
    }

    @Override
    public LineBuffer turn(int player) {
        text.setLength(0);
        codec.writeTurn(text, player);
        return bytes();
    }

    @Override
    public LineBuffer end(int player) {
        text.setLength(0);
        return bytes();
    }

    private LineBuffer bytes() {
        buffer.reset();
        byte[] bytes = text.toString().getBytes(StandardCharsets.UTF_8);
        buffer.write(bytes, 0, bytes.length);
        return buffer;
    }

    @Override
    public int answerLines(int player) {
        return codec.answerLines(player);
    }

    @Override
    public String readAnswer(int player, byte[] answer, int length) {
        return codec.readAnswer(player, answer, length);
    }

    @Override
    public String message(int player) {
        return codec.message(player);
    }
}
