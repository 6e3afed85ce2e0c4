package steward.game.meanmax.protocol;

import steward.game.meanmax.MeanMax;
import steward.game.meanmax.MeanMaxWorld;
import steward.game.meanmax.SkillEffect;
import steward.game.meanmax.UnitKind;
import steward.game.meanmax.Wreck;
import steward.json.JsonNumbers;
import steward.physics.Bodies;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.SerializableString;
import tools.jackson.core.io.SerializedString;

/** Units, wrecks and effects as JSON, the same in frames and states, but for what only the game needs to go on. */
final class UnitJson {

    /** The names that every turn writes, encoded once. */
    private static final class Name {
        static final SerializedString ID = new SerializedString("id");
        static final SerializedString KIND = new SerializedString("kind");
        static final SerializedString PLAYER = new SerializedString("player");
        static final SerializedString X = new SerializedString("x");
        static final SerializedString Y = new SerializedString("y");
        static final SerializedString VX = new SerializedString("vx");
        static final SerializedString VY = new SerializedString("vy");
        static final SerializedString MASS = new SerializedString("mass");
        static final SerializedString RADIUS = new SerializedString("radius");
        static final SerializedString WATER = new SerializedString("water");
        static final SerializedString SIZE = new SerializedString("size");
        static final SerializedString FOR = new SerializedString("spawnedFor");
        static final SerializedString WRECKS = new SerializedString("wrecks");
        static final SerializedString EFFECTS = new SerializedString("effects");
        static final SerializedString SKILL = new SerializedString("skill");
        static final SerializedString DURATION = new SerializedString("duration");
        static final SerializedString LOOTER = new SerializedString("looter");
    }

    /** @param whole with what bots do not see: the player that a tanker was spawned for */
    static void writeUnits(JsonGenerator out, SerializableString name, MeanMax game, boolean whole) {
        MeanMaxWorld world = game.world();
        Bodies bodies = world.bodies();
        out.writeName(name);
        out.writeStartArray();
        for (int unit = 0; unit < bodies.size(); unit++) {
            boolean tanker = world.isTanker(unit);
            int owner = (int) bodies.columns[MeanMaxWorld.OWNER][unit];
            out.writeStartObject();
            JsonNumbers.write(out, Name.ID, bodies.id(unit));
            out.writeName(Name.KIND);
            out.writeString(UnitKind.of(bodies.kind[unit]).text());
            if (!tanker) {
                JsonNumbers.write(out, Name.PLAYER, owner);
            }
            JsonNumbers.write(out, Name.X, bodies.x[unit]);
            JsonNumbers.write(out, Name.Y, bodies.y[unit]);
            JsonNumbers.write(out, Name.VX, bodies.vx[unit]);
            JsonNumbers.write(out, Name.VY, bodies.vy[unit]);
            JsonNumbers.write(out, Name.MASS, bodies.mass[unit]);
            JsonNumbers.write(out, Name.RADIUS, bodies.radius[unit]);
            if (tanker) {
                JsonNumbers.write(out, Name.WATER, (int) bodies.columns[MeanMaxWorld.WATER][unit]);
                JsonNumbers.write(out, Name.SIZE, (int) bodies.columns[MeanMaxWorld.SIZE][unit]);
                if (whole) {
                    JsonNumbers.write(out, Name.FOR, owner);
                }
            }
            out.writeEndObject();
        }
        out.writeEndArray();
    }

    /** The fields {@code wrecks} and {@code effects}. */
    static void writePlaces(JsonGenerator out, MeanMax game) {
        MeanMaxWorld world = game.world();
        out.writeName(Name.WRECKS);
        out.writeStartArray();
        for (int k = 0; k < world.wrecks().size(); k++) {
            Wreck wreck = world.wrecks().get(k);
            out.writeStartObject();
            JsonNumbers.write(out, Name.ID, wreck.id());
            JsonNumbers.write(out, Name.X, wreck.x());
            JsonNumbers.write(out, Name.Y, wreck.y());
            JsonNumbers.write(out, Name.RADIUS, wreck.radius());
            JsonNumbers.write(out, Name.WATER, wreck.water());
            out.writeEndObject();
        }
        out.writeEndArray();
        out.writeName(Name.EFFECTS);
        out.writeStartArray();
        for (int k = 0; k < world.effects().size(); k++) {
            SkillEffect effect = world.effects().get(k);
            out.writeStartObject();
            JsonNumbers.write(out, Name.ID, effect.id());
            out.writeName(Name.SKILL);
            out.writeString(effect.skill().text());
            JsonNumbers.write(out, Name.X, effect.x());
            JsonNumbers.write(out, Name.Y, effect.y());
            JsonNumbers.write(out, Name.DURATION, effect.duration());
            JsonNumbers.write(out, Name.LOOTER, effect.looter());
            out.writeEndObject();
        }
        out.writeEndArray();
    }
}
