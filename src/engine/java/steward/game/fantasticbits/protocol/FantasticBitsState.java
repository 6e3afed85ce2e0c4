package steward.game.fantasticbits.protocol;

import steward.game.CommandListState;
import steward.game.fantasticbits.FantasticBits;
import steward.game.fantasticbits.Pitch;
import steward.game.fantasticbits.WizardCommand;
import steward.json.JsonNumbers;
import steward.json.JsonObject;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.io.SerializedString;

/**
 * Commands and states of Fantastic Bits as a replay keeps them. A recorded command that the state does not allow, since
 * another bot has changed the course of the match, is read and does nothing.
 */
final class FantasticBitsState extends CommandListState<WizardCommand> {

    private static final SerializedString BODIES = new SerializedString("bodies");

    private final FantasticBits game;

    FantasticBitsState(FantasticBits game) {
        super(new FantasticBitsAnswer(null));
        this.game = game;
    }

    /** The fields {@code scores} and {@code magic}, per player. */
    static void writePlayers(JsonGenerator out, FantasticBits game) {
        JsonNumbers.writeAll(out, "scores", game.players(), game::score);
        JsonNumbers.writeAll(out, "magic", game.players(), game::magic);
    }

    @Override
    protected int commands(int player) {
        return Pitch.WIZARDS_PER_PLAYER;
    }

    @Override
    protected WizardCommand command(int player, int wizard) {
        return game.command(player, wizard);
    }

    @Override
    protected void command(int player, int wizard, WizardCommand command) {
        game.command(player, wizard, command);
    }

    @Override
    protected void writeFields(JsonGenerator out, WizardCommand command) {
        FantasticBitsAnswer.write(out, command);
    }

    @Override
    public void writeState(JsonGenerator out) {
        EntityJson.write(out, BODIES, game, true);
        writePlayers(out, game);
    }

    @Override
    public void writeProgress(JsonGenerator out) {
        JsonNumbers.writeAll(out, "scores", game.players(), game::score);
        JsonObject.writeAll(out, "resources", game.players(),
            player -> out.writeNumberProperty("magic", game.magic(player)));
    }
}
