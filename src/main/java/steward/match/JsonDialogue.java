package steward.match;

import java.util.Map;
import steward.bot.LineBuffer;
import steward.game.Game;
import steward.game.GameJson;
import steward.game.GameSetup;
import steward.json.JsonNumbers;
import steward.scene.Time;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.ObjectWriteContext;

/**
 * Dialogue in the JSON protocol: one setup frame, one turn frame per turn, one end frame. Each frame is a JSON object
 * and a line feed in UTF-8; an answer is one line.
 */
final class JsonDialogue implements Dialogue {

    private final GameSetup setup;
    private final Game game;
    private final GameJson frames;
    private final Map<Integer, Time> limits;
    private final LineBuffer buffer = new LineBuffer();
    /** Stays open across lines; opening one per line would cost time. */
    private final JsonGenerator out = JsonNumbers.FACTORY.createGenerator(ObjectWriteContext.empty(), buffer);

    JsonDialogue(GameSetup setup, Game game, GameJson frames, Map<Integer, Time> limits) {
        this.setup = setup;
        this.game = game;
        this.frames = frames;
        this.limits = limits;
    }

    @Override
    public LineBuffer setup(int player) {
        begin("setup");
        out.writeStringProperty("game", setup.scene().gameId());
        out.writeNumberProperty("player", player);
        out.writeNumberProperty("players", game.players());
        Time time = limits.getOrDefault(player, setup.scene().time());
        out.writeObjectPropertyStart("time");
        out.writeNumberProperty("firstAnswerMs", time.firstAnswerMs());
        out.writeNumberProperty("answerMs", time.answerMs());
        out.writeEndObject();
        frames.writeSetup(out, player);
        return line();
    }

    @Override
    public LineBuffer turn(int player) {
        begin("turn");
        out.writeNumberProperty("turn", game.turn() + 1);
        frames.writeTurn(out, player);
        return line();
    }

    @Override
    public LineBuffer end(int player) {
        begin("end");
        out.writeNumberProperty("player", player);
        out.writeNumberProperty("turns", game.turn());
        int[] ranks = game.ranks();
        JsonNumbers.writeAll(out, "ranks", ranks.length, each -> ranks[each]);
        JsonNumbers.writeAll(out, "scores", game.scores());
        out.writeStringProperty("reason", game.ending());
        return line();
    }

    @Override
    public int answerLines(int player) {
        return 1;
    }

    @Override
    public String readAnswer(int player, byte[] answer, int length) {
        return frames.readAnswer(player, answer, length);
    }

    @Override
    public String message(int player) {
        return frames.message(player);
    }

    private void begin(String type) {
        buffer.reset();
        out.writeStartObject();
        out.writeStringProperty("type", type);
    }

    private LineBuffer line() {
        out.writeEndObject();
        out.flush();
        buffer.write('\n');
        return buffer;
    }
}
