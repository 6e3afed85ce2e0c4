package steward.match;

import java.io.ByteArrayOutputStream;
import java.util.function.Consumer;
import steward.game.FrameCodec;
import steward.game.Game;
import steward.game.GameSetup;
import steward.game.JsonNumbers;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.ObjectWriteContext;

/**
 * Makes the lines that a player is sent: one setup frame, a turn frame per turn, one end frame; each a JSON object and
 * a line feed, UTF-8. The referee sends them, and a replay can show them again, because they follow from the game.
 */
public final class Frames {

    private final GameSetup setup;
    private final Game game;
    private final FrameCodec codec;
    private final LineBuffer buffer = new LineBuffer();

    public Frames(GameSetup setup, Game game, FrameCodec codec) {
        this.setup = setup;
        this.game = game;
        this.codec = codec;
    }

    /** The setup frame of a player; valid until the next frame is made. */
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

    /** The frame of the turn about to be played, for a player; valid until the next frame is made. */
    public LineBuffer turn(int player) {
        return line("turn", out -> {
            out.writeNumberProperty("turn", game.turn() + 1);
            codec.writeTurn(out, player);
        });
    }

    /** The end frame, for every player alike but for the number; valid until the next frame is made. */
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

    /** Bytes that can be read in place. */
    public static final class LineBuffer extends ByteArrayOutputStream {

        private LineBuffer() {
            super(4096);
        }

        /** The bytes themselves, valid up to {@code size()}. */
        public byte[] bytes() {
            return buf;
        }
    }
}
