package steward.game.pokerchiprace.protocol;

import java.util.List;
import steward.game.Drawing;
import steward.game.pokerchiprace.ChipTable;
import steward.game.pokerchiprace.PokerChipRace;
import steward.json.DrawingJson;
import steward.json.WallJson;
import steward.physics.Bodies;
import steward.physics.Wall;
import tools.jackson.core.JsonGenerator;

/** Shapes of a table: its walls, and the players' chips at the start; their radii are in the states. */
record PokerChipRaceDrawing(PokerChipRace game, List<Wall> walls) implements Drawing {

    @Override
    public void write(JsonGenerator out) {
        DrawingJson.field(out, -ChipTable.HALF_WIDTH, -ChipTable.HALF_HEIGHT, 2 * ChipTable.HALF_WIDTH,
            2 * ChipTable.HALF_HEIGHT);
        WallJson.write(out, walls);
        out.writeArrayPropertyStart("bodies");
        ChipTable table = game.table();
        Bodies bodies = game.bodies();
        for (int chip = 0; chip < bodies.size(); chip++) {
            if (table.owner(chip) != ChipTable.NEUTRAL) {
                int id = bodies.id(chip);
                DrawingJson.body(out, id, "chip", bodies.radius[chip], table.owner(chip), Integer.toString(id));
            }
        }
        out.writeEndArray();
    }
}
