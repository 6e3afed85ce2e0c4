package steward.game.bodies.protocol;

import steward.game.CommandListState;
import steward.json.DrawingJson;
import steward.json.JsonNumbers;
import steward.json.JsonObject;
import steward.game.bodies.BodiesGame;
import steward.game.bodies.BodiesGame.Thrust;
import tools.jackson.core.JsonGenerator;

/** Commands and states as a replay keeps them: discs and points. */
final class BodiesState extends CommandListState<Thrust> {

    private final BodiesGame game;
    private final BodiesAnswer answer;

    BodiesState(BodiesGame game) {
        this(game, new BodiesAnswer(game));
    }

    private BodiesState(BodiesGame game, BodiesAnswer answer) {
        super(answer);
        this.game = game;
        this.answer = answer;
    }

    @Override
    protected int commands(int player) {
        return game.owned(player).length;
    }

    @Override
    protected Thrust command(int player, int index) {
        return game.thrust(game.owned(player)[index]);
    }

    @Override
    protected void command(int player, int index, Thrust thrust) {
        game.thrust(game.owned(player)[index], thrust);
    }

    @Override
    protected void writeFields(JsonGenerator out, Thrust thrust) {
        BodiesAnswer.write(out, thrust);
    }

    @Override
    protected void expect(int player) {
        answer.expect(player);
    }

    @Override
    public void writeState(JsonGenerator out) {
        writeBodies(out, game);
        JsonObject.writeEach(out, "points", game.players(), player -> out.writeNumber(game.points(player)));
    }

    /** The field {@code bodies}: where the discs are and how fast. */
    static void writeBodies(JsonGenerator out, BodiesGame game) {
        JsonObject.writeAll(out, "bodies", game.discsLeft(), k -> DrawingJson.motion(out, game.bodies(), k));
    }

    @Override
    public void writeProgress(JsonGenerator out) {
        if (game.players() > 0) {
            writeScores(out, game);
        }
    }

    static void writeScores(JsonGenerator out, BodiesGame game) {
        JsonNumbers.writeAll(out, "scores", game.scores());
    }
}
