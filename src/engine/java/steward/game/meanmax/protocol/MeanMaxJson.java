package steward.game.meanmax.protocol;

import java.util.List;
import steward.game.CommandsJson;
import steward.game.meanmax.LooterCommand;
import steward.game.meanmax.MeanMax;
import steward.game.meanmax.MeanMaxWorld;
import steward.game.meanmax.Skill;
import steward.game.meanmax.SkillEffect;
import steward.game.meanmax.UnitKind;
import steward.game.meanmax.Wreck;
import steward.json.DrawingJson;
import steward.json.JsonNumbers;
import steward.json.JsonObject;
import steward.physics.Bodies;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.io.SerializedString;

/** JSON of Mean Max: frames, commands, states and drawing; {@link MeanMaxAnswer} reads answers. */
public final class MeanMaxJson extends CommandsJson<LooterCommand> {

    /** Around the arena tankers come and go. */
    private static final double MARGIN = 2000;
    private static final SerializedString UNITS = new SerializedString("units");
    private static final SerializedString BODIES = new SerializedString("bodies");
    private static final SerializedString ID = new SerializedString("id");
    private static final SerializedString KIND = new SerializedString("kind");
    private static final SerializedString PLAYER = new SerializedString("player");
    private static final SerializedString MASS = new SerializedString("mass");
    private static final SerializedString RADIUS = new SerializedString("radius");
    private static final SerializedString WATER = new SerializedString("water");
    private static final SerializedString SIZE = new SerializedString("size");
    private static final SerializedString FOR = new SerializedString("spawnedFor");

    private final MeanMax game;
    private final MeanMaxWorld world;

    MeanMaxJson(MeanMax game) {
        super(game.players(), new MeanMaxAnswer(), new MeanMaxAnswer());
        this.game = game;
        world = game.world();
    }

    /** State of a game. @param bodies its units in play */
    public record State(List<Unit> bodies, List<Place> wrecks, List<Place> effects, int[] scores, int[] rages,
                        int[] tankersLeft, int nextId) { }

    /** A looter, or a tanker: it has water, a size and whom it was spawned for in place of a player. */
    public record Unit(int id, String kind, Integer player, double x, double y, double vx, double vy, double mass,
                       double radius, Integer water, Integer size, Integer spawnedFor) { }

    /** A wreck with radius and water, or a skill at work with its duration and the id of the looter that cast it. */
    public record Place(int id, String skill, double x, double y, Double radius, Integer water, Integer duration,
                        Integer looter) { }

    @Override
    public void writeSetup(JsonGenerator out, int player) {
        JsonNumbers.write(out, "arenaRadius", MeanMaxWorld.ARENA_RADIUS);
        JsonNumbers.write(out, "waterRadius", MeanMaxWorld.WATER_RADIUS);
        out.writeNumberProperty("maximumPower", LooterCommand.MOST_POWER);
        out.writeNumberProperty("maximumRage", MeanMax.MOST_RAGE);
        out.writeNumberProperty("winningScore", game.settings().winningScore());
        out.writeNumberProperty("maximumTurns", game.settings().maximumTurns());
        JsonObject.writeAll(out, "looters", game.settings().looters(), looter -> {
            UnitKind kind = UnitKind.of(looter);
            out.writeStringProperty("kind", kind.text());
            JsonNumbers.write(out, "mass", kind.mass());
            JsonNumbers.write(out, "friction", kind.friction());
            if (game.settings().isActive(kind.skill())) {
                out.writeStringProperty("skill", kind.skill().text());
            }
        });
        JsonObject.writeAll(out, "skills", List.of(Skill.values()).stream().filter(game.settings()::isActive).toList(),
            skill -> {
                out.writeStringProperty("skill", skill.text());
                out.writeNumberProperty("cost", skill.cost());
                out.writeNumberProperty("turns", skill.turns());
                JsonNumbers.write(out, "radius", MeanMaxWorld.SKILL_RADIUS);
                JsonNumbers.write(out, "range", MeanMaxWorld.SKILL_RANGE);
            });
    }

    @Override
    public void writeTurn(JsonGenerator out, int player) {
        writePlayers(out);
        writeUnits(out, UNITS, false);
        writePlaces(out);
    }

    /** @param whole with what bots do not see: the player that a tanker was spawned for */
    private void writeUnits(JsonGenerator out, SerializedString name, boolean whole) {
        Bodies bodies = world.bodies();
        out.writeName(name);
        out.writeStartArray();
        for (int unit = 0; unit < bodies.size(); unit++) {
            boolean tanker = world.isTanker(unit);
            int owner = (int) bodies.columns[MeanMaxWorld.OWNER][unit];
            out.writeStartObject();
            JsonNumbers.write(out, ID, bodies.id(unit));
            out.writeName(KIND);
            out.writeString(UnitKind.of(bodies.kind[unit]).text());
            if (!tanker) {
                JsonNumbers.write(out, PLAYER, owner);
            }
            DrawingJson.flight(out, bodies, unit);
            JsonNumbers.write(out, MASS, bodies.mass[unit]);
            JsonNumbers.write(out, RADIUS, bodies.radius[unit]);
            if (tanker) {
                JsonNumbers.write(out, WATER, (int) bodies.columns[MeanMaxWorld.WATER][unit]);
                JsonNumbers.write(out, SIZE, (int) bodies.columns[MeanMaxWorld.SIZE][unit]);
                if (whole) {
                    JsonNumbers.write(out, FOR, owner);
                }
            }
            out.writeEndObject();
        }
        out.writeEndArray();
    }

    private void writePlayers(JsonGenerator out) {
        JsonNumbers.writeAll(out, "scores", game.players(), game::score);
        JsonNumbers.writeAll(out, "rages", game.players(), game::rage);
    }

    private void writePlaces(JsonGenerator out) {
        out.writeArrayPropertyStart("wrecks");
        for (int k = 0; k < world.wrecks().size(); k++) {
            Wreck wreck = world.wrecks().get(k);
            out.writeStartObject();
            JsonNumbers.write(out, ID, wreck.id());
            JsonNumbers.write(out, "x", wreck.x());
            JsonNumbers.write(out, "y", wreck.y());
            JsonNumbers.write(out, RADIUS, wreck.radius());
            JsonNumbers.write(out, WATER, wreck.water());
            out.writeEndObject();
        }
        out.writeEndArray();
        out.writeArrayPropertyStart("effects");
        for (int k = 0; k < world.effects().size(); k++) {
            SkillEffect effect = world.effects().get(k);
            out.writeStartObject();
            JsonNumbers.write(out, ID, effect.id());
            out.writeStringProperty("skill", effect.skill().text());
            JsonNumbers.write(out, "x", effect.x());
            JsonNumbers.write(out, "y", effect.y());
            out.writeNumberProperty("duration", effect.duration());
            out.writeNumberProperty("looter", effect.looter());
            out.writeEndObject();
        }
        out.writeEndArray();
    }

    @Override
    public void writeState(JsonGenerator out) {
        writeUnits(out, BODIES, true);
        writePlaces(out);
        writePlayers(out);
        JsonNumbers.writeAll(out, "tankersLeft", game.players(), world.queue()::left);
        out.writeNumberProperty("nextId", game.bodies().nextId());
    }

    @Override
    public void writeProgress(JsonGenerator out) {
        out.writeArrayPropertyStart("zones");
        for (int k = 0; k < world.wrecks().size(); k++) {
            Wreck wreck = world.wrecks().get(k);
            DrawingJson.zone(out, wreck.x(), wreck.y(), wreck.radius(), "wreck " + wreck.water());
        }
        for (int k = 0; k < world.effects().size(); k++) {
            SkillEffect effect = world.effects().get(k);
            DrawingJson.zone(out, effect.x(), effect.y(), MeanMaxWorld.SKILL_RADIUS, effect.skill().text());
        }
        out.writeEndArray();
        JsonNumbers.writeAll(out, "scores", game.players(), game::score);
        JsonObject.writeAll(out, "resources", game.players(),
            player -> out.writeNumberProperty("rage", game.rage(player)));
    }

    @Override
    public void writeDrawing(JsonGenerator out) {
        double side = MeanMaxWorld.ARENA_RADIUS + MARGIN;
        DrawingJson.field(out, -side, -side, 2 * side, 2 * side);
        out.writeArrayPropertyStart("zones");
        DrawingJson.zone(out, 0, 0, MeanMaxWorld.ARENA_RADIUS, "arena");
        DrawingJson.zone(out, 0, 0, MeanMaxWorld.WATER_RADIUS, "water");
        out.writeEndArray();
        Bodies bodies = game.bodies();
        JsonObject.writeEach(out, "bodies", game.players() * game.settings().looters(), unit -> {
            String kind = UnitKind.of(bodies.kind[unit]).text();
            DrawingJson.body(out, bodies.id(unit), kind, bodies.radius[unit], game.playerOf(bodies.id(unit)),
                kind.substring(0, 2));
        });
    }

    @Override
    protected int commands(int player) {
        return UnitKind.LOOTERS;
    }

    @Override
    protected LooterCommand command(int player, int looter) {
        return game.command(player, looter);
    }

    @Override
    protected void command(int player, int looter, LooterCommand command) {
        game.command(player, looter, command);
    }

    @Override
    protected void writeFields(JsonGenerator out, LooterCommand command) {
        MeanMaxAnswer.write(out, command);
    }
}
