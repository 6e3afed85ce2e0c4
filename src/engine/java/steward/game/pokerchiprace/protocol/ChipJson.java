package steward.game.pokerchiprace.protocol;

import steward.game.pokerchiprace.ChipTable;
import steward.game.pokerchiprace.PokerChipRace;
import steward.json.JsonNumbers;
import steward.physics.Bodies;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.SerializableString;
import tools.jackson.core.io.SerializedString;

/** Chips as JSON, the same in frames and states: {@code player} is there unless a chip is neutral. */
final class ChipJson {

    /** The names that every turn writes, encoded once. */
    private static final class Name {
        static final SerializedString ID = new SerializedString("id");
        static final SerializedString PLAYER = new SerializedString("player");
        static final SerializedString RADIUS = new SerializedString("radius");
        static final SerializedString X = new SerializedString("x");
        static final SerializedString Y = new SerializedString("y");
        static final SerializedString VX = new SerializedString("vx");
        static final SerializedString VY = new SerializedString("vy");
    }

    /** All chips in play, in the order of their ids. */
    static void write(JsonGenerator out, SerializableString name, PokerChipRace game) {
        Bodies bodies = game.bodies();
        out.writeName(name);
        out.writeStartArray();
        for (int chip = 0; chip < bodies.size(); chip++) {
            out.writeStartObject();
            JsonNumbers.write(out, Name.ID, bodies.id(chip));
            if (game.ownerOf(chip) != ChipTable.NEUTRAL) {
                JsonNumbers.write(out, Name.PLAYER, game.ownerOf(chip));
            }
            JsonNumbers.write(out, Name.RADIUS, bodies.radius[chip]);
            JsonNumbers.write(out, Name.X, bodies.x[chip]);
            JsonNumbers.write(out, Name.Y, bodies.y[chip]);
            JsonNumbers.write(out, Name.VX, bodies.vx[chip]);
            JsonNumbers.write(out, Name.VY, bodies.vy[chip]);
            out.writeEndObject();
        }
        out.writeEndArray();
    }
}
