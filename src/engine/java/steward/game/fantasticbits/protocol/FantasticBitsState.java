package steward.game.fantasticbits.protocol;

import steward.game.StateCodec;
import steward.game.fantasticbits.FantasticBits;
import steward.game.fantasticbits.Pitch;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.JsonParser;
import tools.jackson.core.io.SerializedString;

/**
 * Commands and states of Fantastic Bits as a replay keeps them. A recorded command that the state does not allow, since
 * another bot has changed the course of the match, is read and does nothing.
 */
final class FantasticBitsState implements StateCodec {

    private static final SerializedString BODIES = new SerializedString("bodies");

    private final FantasticBits game;
    private final WizardCommandJson commands;

    FantasticBitsState(FantasticBits game) {
        this.game = game;
        commands = new WizardCommandJson(null);
    }

    /** The fields {@code scores} and {@code magic}, per player. */
    static void writePlayers(JsonGenerator out, FantasticBits game) {
        writeScores(out, game);
        out.writeArrayPropertyStart("magic");
        for (int player = 0; player < game.players(); player++) {
            out.writeNumber(game.magic(player));
        }
        out.writeEndArray();
    }

    private static void writeScores(JsonGenerator out, FantasticBits game) {
        out.writeArrayPropertyStart("scores");
        for (int player = 0; player < game.players(); player++) {
            out.writeNumber(game.score(player));
        }
        out.writeEndArray();
    }

    @Override
    public void writeCommand(JsonGenerator out, int player) {
        out.writeStartArray();
        for (int wizard = 0; wizard < Pitch.WIZARDS_PER_PLAYER; wizard++) {
            WizardCommandJson.write(out, game.command(player, wizard));
        }
        out.writeEndArray();
    }

    @Override
    public String readCommand(JsonParser in, int player) {
        return read(in, player, false);
    }

    @Override
    public String readPartialCommand(JsonParser in, int player) {
        return read(in, player, true);
    }

    private String read(JsonParser in, int player, boolean partial) {
        String wrong = commands.read(in, player, partial);
        for (int wizard = 0; wrong == null && wizard < Pitch.WIZARDS_PER_PLAYER; wizard++) {
            game.command(player, wizard, commands.command(wizard));
        }
        return wrong;
    }

    @Override
    public boolean hasPartialCommand(int player) {
        return game.command(player, 0) != null;
    }

    @Override
    public void clearCommand(int player) {
        for (int wizard = 0; wizard < Pitch.WIZARDS_PER_PLAYER; wizard++) {
            game.command(player, wizard, null);
        }
    }

    @Override
    public void writeState(JsonGenerator out) {
        EntityJson.write(out, BODIES, game, true);
        writePlayers(out, game);
    }

    @Override
    public void writeProgress(JsonGenerator out) {
        writeScores(out, game);
        out.writeArrayPropertyStart("resources");
        for (int player = 0; player < game.players(); player++) {
            out.writeStartObject();
            out.writeNumberProperty("magic", game.magic(player));
            out.writeEndObject();
        }
        out.writeEndArray();
    }
}
