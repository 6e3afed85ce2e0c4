package steward.game.meanmax.protocol;

import steward.game.CommandListState;
import steward.game.meanmax.LooterCommand;
import steward.game.meanmax.MeanMax;
import steward.game.meanmax.MeanMaxWorld;
import steward.game.meanmax.SkillEffect;
import steward.game.meanmax.UnitKind;
import steward.game.meanmax.Wreck;
import steward.json.DrawingJson;
import steward.json.JsonNumbers;
import steward.json.JsonObject;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.io.SerializedString;

/** Commands and states of Mean Max as a replay keeps them. */
final class MeanMaxState extends CommandListState<LooterCommand> {

    private static final SerializedString BODIES = new SerializedString("bodies");

    private final MeanMax game;

    MeanMaxState(MeanMax game) {
        super(new MeanMaxAnswer());
        this.game = game;
    }

    /** The fields {@code scores} and {@code rages}, per player. */
    static void writePlayers(JsonGenerator out, MeanMax game) {
        JsonNumbers.writeAll(out, "scores", game.players(), game::score);
        JsonNumbers.writeAll(out, "rages", game.players(), game::rage);
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

    @Override
    public void writeState(JsonGenerator out) {
        UnitJson.writeUnits(out, BODIES, game, true);
        UnitJson.writePlaces(out, game);
        writePlayers(out, game);
        JsonNumbers.writeAll(out, "tankersLeft", game.players(), game.world().queue()::left);
        out.writeNumberProperty("nextId", game.bodies().nextId());
    }

    @Override
    public void writeProgress(JsonGenerator out) {
        MeanMaxWorld world = game.world();
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
}
