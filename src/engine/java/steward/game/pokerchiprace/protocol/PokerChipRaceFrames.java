package steward.game.pokerchiprace.protocol;

import steward.game.BotFrames;
import steward.game.pokerchiprace.ChipTable;
import steward.game.pokerchiprace.PokerChipRace;
import steward.json.DrawingJson;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.io.SerializedString;

/** JSON frames that bots are sent; answers are read by {@link PokerChipRaceAnswer}. */
final class PokerChipRaceFrames implements BotFrames {

    private static final SerializedString CHIPS = new SerializedString("chips");
    private static final SerializedString OWN = new SerializedString("own");

    private final PokerChipRace game;
    private final PokerChipRaceAnswer answer = PokerChipRaceAnswer.ofBot();
    private final String[] messages;

    PokerChipRaceFrames(PokerChipRace game) {
        this.game = game;
        messages = new String[game.players()];
    }

    @Override
    public void writeSetup(JsonGenerator out, int player) {
        DrawingJson.field(out, -ChipTable.HALF_WIDTH, -ChipTable.HALF_HEIGHT, 2 * ChipTable.HALF_WIDTH,
            2 * ChipTable.HALF_HEIGHT);
        out.writeNumberProperty("smallRadius", (int) ChipTable.SMALL);
        out.writeNumberProperty("maximumTurns", game.settings().maximumTurns());
    }

    @Override
    public void writeTurn(JsonGenerator out, int player) {
        ChipTable table = game.table();
        out.writeName(OWN);
        out.writeStartArray();
        for (int k = 0; k < table.owned(player); k++) {
            out.writeNumber(table.ownId(player, k));
        }
        out.writeEndArray();
        ChipJson.write(out, CHIPS, game);
    }

    @Override
    public String readAnswer(int player, byte[] line, int length) {
        messages[player] = null;
        int own = game.table().owned(player);
        String wrong = answer.expect(own).read(line, length);
        if (wrong == null) {
            messages[player] = answer.message();
            for (int k = 0; k < own; k++) {
                game.command(player, k, answer.command(k));
            }
        }
        return wrong;
    }

    @Override
    public String message(int player) {
        return messages[player];
    }
}
