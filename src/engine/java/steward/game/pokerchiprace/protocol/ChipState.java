package steward.game.pokerchiprace.protocol;

import steward.game.JsonNumbers;
import steward.game.StateCodec;
import steward.game.pokerchiprace.ChipTable;
import steward.game.pokerchiprace.PokerChipRace;
import steward.physics.PassingPairs;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.JsonParser;
import tools.jackson.core.io.SerializedString;

/** Commands and states of the Poker Chip Race as a replay keeps them. */
final class ChipState implements StateCodec {

    private static final SerializedString BODIES = new SerializedString("bodies");

    private final PokerChipRace game;
    private final ChipCommandJson commands = new ChipCommandJson(Double.MAX_VALUE);

    ChipState(PokerChipRace game) {
        this.game = game;
    }

    @Override
    public void writeCommand(JsonGenerator out, int player) {
        out.writeStartArray();
        for (int k = 0; k < game.table().owned(player); k++) {
            ChipCommandJson.write(out, game.command(player, k));
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
        int own = game.table().owned(player);
        String wrong = commands.read(in, own, partial);
        for (int k = 0; wrong == null && k < own; k++) {
            game.command(player, k, commands.command(k));
        }
        return wrong;
    }

    @Override
    public boolean hasPartialCommand(int player) {
        return game.table().owned(player) > 0 && game.command(player, 0) != null;
    }

    @Override
    public void clearCommand(int player) {
        for (int k = 0; k < game.table().owned(player); k++) {
            game.command(player, k, null);
        }
    }

    /** The list of a player's chips is that of its bodies, in their order. */
    @Override
    public void writeState(JsonGenerator out) {
        ChipJson.write(out, BODIES, game);
        PassingPairs pairs = game.bodies().passing();
        out.writeArrayPropertyStart("contacts");
        for (int k = 0; k < pairs.size(); k++) {
            out.writeStartArray();
            out.writeNumber(pairs.first(k));
            out.writeNumber(pairs.second(k));
            out.writeEndArray();
        }
        out.writeEndArray();
        out.writeArrayPropertyStart("lost");
        for (int player = 0; player < game.players(); player++) {
            if (game.lost(player) < 0) {
                out.writeNull();
            } else {
                JsonNumbers.write(out, game.lost(player));
            }
        }
        out.writeEndArray();
        out.writeNumberProperty("nextId", game.bodies().nextId());
    }

    @Override
    public void writeProgress(JsonGenerator out) {
        out.writeArrayPropertyStart("scores");
        for (int player = 0; player < game.players(); player++) {
            out.writeNumber(game.score(player));
        }
        out.writeEndArray();
        out.writeArrayPropertyStart("resources");
        ChipTable table = game.table();
        for (int player = 0; player < game.players(); player++) {
            out.writeStartObject();
            out.writeNumberProperty("chips", table.owned(player));
            out.writeEndObject();
        }
        out.writeEndArray();
    }
}
