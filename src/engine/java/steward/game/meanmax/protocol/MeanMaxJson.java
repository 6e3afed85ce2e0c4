package steward.game.meanmax.protocol;

import java.util.List;
import java.util.function.IntPredicate;
import java.util.function.IntUnaryOperator;
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
import steward.json.ObjectFields;
import steward.physics.Bodies;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.io.SerializedString;

/** All JSON of Mean Max; answers are read by {@link MeanMaxAnswer}. */
public final class MeanMaxJson extends CommandsJson<LooterCommand> {

    /** Around the arena tankers come and go. */
    private static final double MARGIN = 2000;
    private static final SerializedString UNITS = new SerializedString("units");
    private static final SerializedString BODIES = new SerializedString("bodies");
    private static final SerializedString WRECKS = new SerializedString("wrecks");
    private static final SerializedString EFFECTS = new SerializedString("effects");

    private final MeanMax game;
    private final MeanMaxWorld world;
    private final ObjectFields units;
    private final ObjectFields wrecks;
    private final ObjectFields effects;

    MeanMaxJson(MeanMax game) {
        super(game.players(), new MeanMaxAnswer(), new MeanMaxAnswer());
        this.game = game;
        world = game.world();
        Bodies bodies = world.bodies();
        IntPredicate tanker = world::isTanker;
        IntUnaryOperator owner = unit -> (int) bodies.columns[MeanMaxWorld.OWNER][unit];
        units = new ObjectFields().whole("id", bodies::id)
            .text("kind", unit -> UnitKind.of(bodies.kind[unit]).text())
            .whole("player", owner).where(tanker.negate())
            .motion(bodies)
            .number("mass", unit -> bodies.mass[unit])
            .number("radius", unit -> bodies.radius[unit])
            .whole("water", unit -> (int) bodies.columns[MeanMaxWorld.WATER][unit]).where(tanker)
            .whole("size", unit -> (int) bodies.columns[MeanMaxWorld.SIZE][unit]).where(tanker)
            .whole("spawnedFor", owner).where(tanker).inStates();
        wrecks = new ObjectFields().whole("id", k -> world.wrecks().get(k).id())
            .number("x", k -> world.wrecks().get(k).x())
            .number("y", k -> world.wrecks().get(k).y())
            .number("radius", k -> world.wrecks().get(k).radius())
            .whole("water", k -> world.wrecks().get(k).water());
        effects = new ObjectFields().whole("id", k -> world.effects().get(k).id())
            .text("skill", k -> world.effects().get(k).skill().text())
            .number("x", k -> world.effects().get(k).x())
            .number("y", k -> world.effects().get(k).y())
            .whole("duration", k -> world.effects().get(k).duration())
            .whole("looter", k -> world.effects().get(k).looter());
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
    public Class<State> stateType() {
        return State.class;
    }

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
        units.writeAll(out, UNITS, game.bodies().size(), false);
        writePlaces(out);
    }

    private void writePlayers(JsonGenerator out) {
        JsonNumbers.writeAll(out, "scores", game.players(), game::score);
        JsonNumbers.writeAll(out, "rages", game.players(), game::rage);
    }

    private void writePlaces(JsonGenerator out) {
        wrecks.writeAll(out, WRECKS, world.wrecks().size(), true);
        effects.writeAll(out, EFFECTS, world.effects().size(), true);
    }

    @Override
    public void writeState(JsonGenerator out) {
        units.writeAll(out, BODIES, game.bodies().size(), true);
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
