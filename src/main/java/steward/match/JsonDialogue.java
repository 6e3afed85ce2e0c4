package steward.match;

import java.util.function.Consumer;
import steward.game.FrameCodec;
import steward.game.Game;
import steward.game.GameSetup;
import steward.game.JsonNumbers;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.ObjectWriteContext;

/**
 * The JSON protocol: one setup frame, a turn frame per turn, one end frame, each a JSON object and a line feed,
 * UTF-8; an answer is one line.
 */
final class JsonDialogue implements Dialogue {

    private final GameSetup setup;
    private final Game game;
    private final FrameCodec codec;
    private final LineBuffer buffer = new LineBuffer();

    JsonDialogue(GameSetup setup, Game game, FrameCodec codec) {
        this.setup = setup;
        this.game = game;
        this.codec = codec;
    }

    @Override
    public LineBuffer setup(int player) {
        return line("setup", out -> {
            out.writeStringProperty("game", setup.scene().gameId());
            out.writeNumberProperty("player", player);
            out.writeNumberProperty("players", game.players());
            out.writeObjectPropertyStart("time");
            out.writeNumberProperty("firstAnswerMs", setup.scene().time().firstAnswerMs());
            out.writeNumberProperty("answerMs", setup.scene().time().answerMs());
            out.writeEndObject();
            codec.writeSetup(out, player);
        });
    }

    @Override
    public LineBuffer turn(int player) {
        return line("turn", out -> {
            out.writeNumberProperty("turn", game.turn() + 1);
            codec.writeTurn(out, player);
        });
    }

    @Override
    public LineBuffer end(int player) {
        return line("end", out -> {
            out.writeNumberProperty("player", player);
            out.writeNumberProperty("turns", game.turn());
            out.writeArrayPropertyStart("ranks");
            for (int rank : game.ranks()) {
                out.writeNumber(rank);
            }
            out.writeEndArray();
            out.writeArrayPropertyStart("scores");
            for (double score : game.scores()) {
                JsonNumbers.write(out, score);
            }
            out.writeEndArray();
            out.writeStringProperty("reason", game.ending());
        });
    }

    @Override
    public int answerLines(int player) {
        return 1;
    }

    @Override
    public String readAnswer(int player, byte[] answer, int length) {
        return codec.readAnswer(player, answer, length);
    }

    @Override
    public String message(int player) {
        return codec.message(player);
    }

    private LineBuffer line(String type, Consumer<JsonGenerator> fields) {
        buffer.reset();
        try (JsonGenerator out = JsonNumbers.FACTORY.createGenerator(ObjectWriteContext.empty(), buffer)) {
            out.writeStartObject();
            out.writeStringProperty("type", type);
            fields.accept(out);
            out.writeEndObject();
        }
        buffer.write('\n');
        return buffer;
    }
}
