package steward.game.meanmax.protocol;

import steward.game.BotFrames;
import steward.game.meanmax.LooterCommand;
import steward.game.meanmax.MeanMax;
import steward.game.meanmax.MeanMaxWorld;
import steward.game.meanmax.Skill;
import steward.game.meanmax.UnitKind;
import steward.json.JsonNumbers;
import steward.json.JsonObject;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.io.SerializedString;

/** JSON frames that bots of Mean Max are sent; answers are read by {@link MeanMaxAnswer}. */
final class MeanMaxFrames implements BotFrames {

    private static final SerializedString UNITS = new SerializedString("units");

    private final MeanMax game;
    private final MeanMaxAnswer answer = new MeanMaxAnswer();
    private final String[] messages;

    MeanMaxFrames(MeanMax game) {
        this.game = game;
        messages = new String[game.players()];
    }

    @Override
    public void writeSetup(JsonGenerator out, int player) {
        JsonNumbers.write(out, "arenaRadius", MeanMaxWorld.ARENA_RADIUS);
        JsonNumbers.write(out, "waterRadius", MeanMaxWorld.WATER_RADIUS);
        out.writeNumberProperty("maximumPower", LooterCommand.MOST_POWER);
        out.writeNumberProperty("maximumRage", MeanMax.MOST_RAGE);
        out.writeNumberProperty("winningScore", game.settings().winningScore());
        out.writeNumberProperty("maximumTurns", game.settings().maximumTurns());
        JsonObject.writeEach(out, "looters", game.settings().looters(), looter -> {
            UnitKind kind = UnitKind.of(looter);
            out.writeStartObject();
            out.writeStringProperty("kind", kind.text());
            JsonNumbers.write(out, "mass", kind.mass());
            JsonNumbers.write(out, "friction", kind.friction());
            if (game.settings().isActive(kind.skill())) {
                out.writeStringProperty("skill", kind.skill().text());
            }
            out.writeEndObject();
        });
        out.writeArrayPropertyStart("skills");
        for (Skill skill : Skill.values()) {
            if (game.settings().isActive(skill)) {
                writeSkill(out, skill);
            }
        }
        out.writeEndArray();
    }

    private static void writeSkill(JsonGenerator out, Skill skill) {
        out.writeStartObject();
        out.writeStringProperty("skill", skill.text());
        out.writeNumberProperty("cost", skill.cost());
        out.writeNumberProperty("turns", skill.turns());
        JsonNumbers.write(out, "radius", MeanMaxWorld.SKILL_RADIUS);
        JsonNumbers.write(out, "range", MeanMaxWorld.SKILL_RANGE);
        out.writeEndObject();
    }

    @Override
    public void writeTurn(JsonGenerator out, int player) {
        MeanMaxState.writePlayers(out, game);
        UnitJson.writeUnits(out, UNITS, game, false);
        UnitJson.writePlaces(out, game);
    }

    @Override
    public String readAnswer(int player, byte[] line, int length) {
        messages[player] = null;
        String wrong = answer.read(line, length);
        if (wrong == null) {
            messages[player] = answer.message();
            for (int looter = 0; looter < UnitKind.LOOTERS; looter++) {
                game.command(player, looter, answer.command(looter));
            }
        }
        return wrong;
    }

    @Override
    public String message(int player) {
        return messages[player];
    }
}
