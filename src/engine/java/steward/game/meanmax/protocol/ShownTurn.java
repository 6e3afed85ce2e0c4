package steward.game.meanmax.protocol;

import java.util.List;
import java.util.Map;
import steward.game.meanmax.MeanMaxWorld;
import steward.game.meanmax.Skill;
import steward.game.meanmax.UnitKind;
import steward.json.JsonNumbers;
import steward.json.JsonObject;
import tools.jackson.core.JsonGenerator;

/**
 * A turn as the server has shown it, in the form of a replay.
 *
 * @param impacts in order
 * @param deaths  tankers that went in this turn, those sunk first
 * @param units   that are there after the turn
 * @param wrecks  likewise
 * @param water   by a wreck's id, what is left after the turn; the next turn shows it, of the last one it is not known
 * @param effects likewise
 * @param scores  per player
 * @param rages   per player
 */
record ShownTurn(List<Impact> impacts, List<Death> deaths, List<Unit> units, List<Wreck> wrecks,
                 Map<Integer, Integer> water, List<Effect> effects, int[] scores, int[] rages) {

    /** @param b {@code null} for the wall of the arena */
    record Impact(double time, Unit a, Unit b) { }

    /** A tanker that was sunk, or left full. */
    record Death(double time, Unit tanker) { }

    /** Kind, radius and owner of a unit, told once. @param player -1 for a tanker */
    record What(UnitKind kind, double radius, int player) { }

    /** A unit at a moment. @param water of a tanker */
    record Unit(int id, What what, double x, double y, double vx, double vy, int water) {

        MeanMaxView.Met met() {
            return new MeanMaxView.Met(id, x, y, vx, vy);
        }
    }

    /** A tanker's remains where it sank. */
    record Wreck(int id, double x, double y, double radius) { }

    /** A skill that works. */
    record Effect(int id, Skill skill, double x, double y, int looter) { }

    /** Fields of the outcome. */
    void writeOutcome(JsonGenerator out) {
        JsonObject.writeEach(out, "impacts", impacts, impact ->
            MeanMaxView.writeImpact(out, impact.time, impact.a.met(), impact.b == null ? null : impact.b.met()));
        JsonObject.writeEach(out, "events", deaths, death ->
            MeanMaxView.writeDeath(out, death.time, death.tanker.id, death.tanker.x, death.tanker.y));
        out.writeArrayPropertyStart("zones");
        for (Wreck wreck : wrecks) {
            Integer left = water.get(wreck.id);
            writeZone(out, wreck.x, wreck.y, wreck.radius, left == null ? null : "wreck " + left);
        }
        for (Effect effect : effects) {
            writeZone(out, effect.x, effect.y, MeanMaxWorld.SKILL_RADIUS, effect.skill.text());
        }
        out.writeEndArray();
        writeNumbers(out, "scores", scores);
        JsonObject.writeAll(out, "resources", rages.length, player -> out.writeNumberProperty("rage", rages[player]));
        out.writeObjectPropertyStart("state");
        writeState(out, false);
        out.writeEndObject();
    }

    private static void writeZone(JsonGenerator out, double x, double y, double radius, String label) {
        out.writeStartObject();
        JsonNumbers.write(out, "x", x);
        JsonNumbers.write(out, "y", y);
        JsonNumbers.write(out, "radius", radius);
        if (label != null) {
            out.writeStringProperty("label", label);
        }
        out.writeEndObject();
    }

    private static void writeNumbers(JsonGenerator out, String name, int[] values) {
        out.writeName(name);
        out.writeArray(values, 0, values.length);
    }

    /** @param speeds whether the speeds shown are those of the state, as before the first turn */
    void writeState(JsonGenerator out, boolean speeds) {
        JsonObject.writeEach(out, "bodies", units, unit -> write(out, unit, speeds));
        JsonObject.writeAll(out, "wrecks", wrecks, wreck -> {
            out.writeNumberProperty("id", wreck.id);
            JsonNumbers.write(out, "x", wreck.x);
            JsonNumbers.write(out, "y", wreck.y);
            JsonNumbers.write(out, "radius", wreck.radius);
            if (water.containsKey(wreck.id)) {
                out.writeNumberProperty("water", water.get(wreck.id));
            }
        });
        JsonObject.writeAll(out, "effects", effects, effect -> {
            out.writeNumberProperty("id", effect.id);
            out.writeStringProperty("skill", effect.skill.text());
            JsonNumbers.write(out, "x", effect.x);
            JsonNumbers.write(out, "y", effect.y);
            out.writeNumberProperty("looter", effect.looter);
        });
        writeNumbers(out, "scores", scores);
        writeNumbers(out, "rages", rages);
    }

    private static void write(JsonGenerator out, Unit unit, boolean speeds) {
        out.writeStartObject();
        out.writeNumberProperty("id", unit.id);
        out.writeStringProperty("kind", unit.what.kind.text());
        if (unit.what.player >= 0) {
            out.writeNumberProperty("player", unit.what.player);
        }
        JsonNumbers.write(out, "x", unit.x);
        JsonNumbers.write(out, "y", unit.y);
        if (speeds) {
            JsonNumbers.write(out, "vx", unit.vx);
            JsonNumbers.write(out, "vy", unit.vy);
        }
        JsonNumbers.write(out, "radius", unit.what.radius);
        if (unit.what.kind == UnitKind.TANKER) {
            out.writeNumberProperty("water", unit.water);
        }
        out.writeEndObject();
    }
}
