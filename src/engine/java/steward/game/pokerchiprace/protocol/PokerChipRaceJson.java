package steward.game.pokerchiprace.protocol;

import java.util.List;
import steward.game.CommandsJson;
import steward.game.pokerchiprace.ChipCommand;
import steward.game.pokerchiprace.ChipTable;
import steward.game.pokerchiprace.PokerChipRace;
import steward.json.DrawingJson;
import steward.json.JsonNumbers;
import steward.json.JsonObject;
import steward.json.WallJson;
import steward.physics.Bodies;
import steward.physics.PassingPairs;
import steward.physics.Wall;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.io.SerializedString;

/** JSON of the Poker Chip Race: frames, commands, states and drawing; {@link PokerChipRaceAnswer} reads answers. */
public final class PokerChipRaceJson extends CommandsJson<ChipCommand> {

    private static final SerializedString BODIES = new SerializedString("bodies");
    private static final SerializedString CHIPS = new SerializedString("chips");
    private static final SerializedString OWN = new SerializedString("own");
    private static final SerializedString ID = new SerializedString("id");
    private static final SerializedString PLAYER = new SerializedString("player");
    private static final SerializedString RADIUS = new SerializedString("radius");

    private final PokerChipRace game;
    private final List<Wall> walls;

    PokerChipRaceJson(PokerChipRace game, List<Wall> walls) {
        super(game.players(), PokerChipRaceAnswer.ofBot(game), PokerChipRaceAnswer.ofReplay(game));
        this.game = game;
        this.walls = walls;
    }

    /**
     * State of a game.
     *
     * @param contacts pairs of ids of chips that are in each other, and have met already
     * @param lost     when each player lost its last chip, the turn and the time within it; or {@code null}
     */
    public record State(List<Chip> bodies, int[][] contacts, Double[] lost, int nextId) { }

    /** A chip. @param player its owner, {@code null} for a neutral one */
    public record Chip(int id, Integer player, double radius, double x, double y, double vx, double vy) { }

    @Override
    public void writeSetup(JsonGenerator out, int player) {
        writeField(out);
        out.writeNumberProperty("smallRadius", (int) ChipTable.SMALL);
        out.writeNumberProperty("maximumTurns", game.settings().maximumTurns());
    }

    private static void writeField(JsonGenerator out) {
        DrawingJson.field(out, -ChipTable.HALF_WIDTH, -ChipTable.HALF_HEIGHT, 2 * ChipTable.HALF_WIDTH,
            2 * ChipTable.HALF_HEIGHT);
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
        writeChips(out, CHIPS);
    }

    /** All chips in play, in the order of their ids, the same in frames and states. */
    private void writeChips(JsonGenerator out, SerializedString name) {
        Bodies bodies = game.bodies();
        out.writeName(name);
        out.writeStartArray();
        for (int chip = 0; chip < bodies.size(); chip++) {
            int owner = game.ownerOf(chip);
            out.writeStartObject();
            JsonNumbers.write(out, ID, bodies.id(chip));
            if (owner != ChipTable.NEUTRAL) {
                JsonNumbers.write(out, PLAYER, owner);
            }
            JsonNumbers.write(out, RADIUS, bodies.radius[chip]);
            DrawingJson.flight(out, bodies, chip);
            out.writeEndObject();
        }
        out.writeEndArray();
    }

    /** The list of a player's chips is that of its bodies, in their order. */
    @Override
    public void writeState(JsonGenerator out) {
        writeChips(out, BODIES);
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

    /** The table's walls, and the players' chips at the start; their radii are in the states. */
    @Override
    public void writeDrawing(JsonGenerator out) {
        writeField(out);
        WallJson.write(out, walls);
        out.writeArrayPropertyStart("bodies");
        Bodies bodies = game.bodies();
        for (int chip = 0; chip < bodies.size(); chip++) {
            int owner = game.table().owner(chip);
            if (owner != ChipTable.NEUTRAL) {
                int id = bodies.id(chip);
                DrawingJson.body(out, id, "chip", bodies.radius[chip], owner, Integer.toString(id));
            }
        }
        out.writeEndArray();
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
    protected void writeFields(JsonGenerator out, ChipCommand command) {
        PokerChipRaceAnswer.write(out, command);
    }
}
