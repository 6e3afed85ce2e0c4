package steward.game.pokerchiprace.protocol;

import steward.game.CommandListState;
import steward.game.pokerchiprace.ChipCommand;
import steward.game.pokerchiprace.PokerChipRace;
import steward.json.JsonNumbers;
import steward.json.JsonObject;
import steward.physics.PassingPairs;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.io.SerializedString;

/** Commands and states of the Poker Chip Race as a replay keeps them. */
final class PokerChipRaceState extends CommandListState<ChipCommand> {

    private static final SerializedString BODIES = new SerializedString("bodies");

    private final PokerChipRace game;
    private final PokerChipRaceAnswer recorded;

    PokerChipRaceState(PokerChipRace game) {
        this(game, PokerChipRaceAnswer.ofReplay());
    }

    private PokerChipRaceState(PokerChipRace game, PokerChipRaceAnswer recorded) {
        super(recorded);
        this.recorded = recorded;
        this.game = game;
    }

    @Override
    protected int commands(int player) {
        return game.table().owned(player);
    }

    @Override
    protected ChipCommand command(int player, int k) {
        return game.command(player, k);
    }

    @Override
    protected void command(int player, int k, ChipCommand command) {
        game.command(player, k, command);
    }

    @Override
    protected void expect(int player) {
        recorded.expect(commands(player));
    }

    @Override
    protected void writeFields(JsonGenerator out, ChipCommand command) {
        PokerChipRaceAnswer.write(out, command);
    }

    /** The list of a player's chips is that of its bodies, in their order. */
    @Override
    public void writeState(JsonGenerator out) {
        ChipJson.write(out, BODIES, game);
        PassingPairs pairs = game.bodies().passing();
        JsonObject.writeEach(out, "contacts", pairs.size(), k -> {
            out.writeStartArray();
            out.writeNumber(pairs.first(k));
            out.writeNumber(pairs.second(k));
            out.writeEndArray();
        });
        JsonObject.writeEach(out, "lost", game.players(), player ->
            JsonNumbers.writeOrNull(out, game.lost(player) < 0 ? Double.NaN : game.lost(player)));
        out.writeNumberProperty("nextId", game.bodies().nextId());
    }

    @Override
    public void writeProgress(JsonGenerator out) {
        JsonNumbers.writeAll(out, "scores", game.players(), game::score);
        JsonObject.writeAll(out, "resources", game.players(),
            player -> out.writeNumberProperty("chips", game.table().owned(player)));
    }
}
