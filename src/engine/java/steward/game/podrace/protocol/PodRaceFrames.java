package steward.game.podrace.protocol;

import java.util.List;
import steward.game.BotFrames;
import steward.game.podrace.PodRace;
import steward.game.podrace.PodRaceSettings;
import steward.game.podrace.RulesEdition;
import steward.json.DrawingJson;
import steward.json.JsonNumbers;
import steward.json.JsonObject;
import steward.scene.Field;
import steward.scene.Scene;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.io.SerializedString;

/** JSON frames that bots of the pod race are sent; answers are read by {@link PodRaceAnswer}. */
final class PodRaceFrames implements BotFrames {

    /** The names that every turn writes, encoded once. */
    private static final class Name {
        static final SerializedString TURNS_LEFT = new SerializedString("turnsLeft");
        static final SerializedString PODS = new SerializedString("pods");
    }

    private final PodRace race;
    private final Scene scene;
    private final PodRaceAnswer answer;
    private final PodJsonCache texts;
    private final String[] messages;

    /** @param texts shared with the state of the same race */
    PodRaceFrames(PodRace race, Scene scene, PodJsonCache texts) {
        this.race = race;
        this.scene = scene;
        this.texts = texts;
        answer = new PodRaceAnswer(race.settings().podsPerPlayer(), race.settings().maximumThrust());
        messages = new String[race.players()];
    }

    @Override
    public void writeSetup(JsonGenerator out, int player) {
        PodRaceSettings settings = race.settings();
        out.writeNumberProperty("podsPerPlayer", settings.podsPerPlayer());
        out.writeNumberProperty("laps", settings.laps());
        JsonObject.writeEach(out, "checkpoints", List.of(race.checkpoints()),
            checkpoint -> DrawingJson.place(out, checkpoint[0], checkpoint[1]));
        JsonNumbers.write(out, "checkpointRadius", settings.checkpointRadius());
        JsonNumbers.write(out, "podRadius", settings.radius());
        JsonNumbers.write(out, "podMass", settings.mass());
        JsonNumbers.write(out, "minimumImpulse", scene.law().minimumImpulse());
        JsonNumbers.write(out, "drag", scene.drag());
        out.writeNumberProperty("maximumThrust", settings.maximumThrust());
        out.writeNumberProperty("boostThrust", PodRaceSettings.BOOST_THRUST);
        if (settings.rules() == RulesEdition.LIVE) {
            out.writeStringProperty("rules", settings.rules().word());
        }
        out.writeNumberProperty("turnsWithoutCheckpoint", settings.turnsWithoutCheckpoint());
        out.writeNumberProperty("maximumTurns", settings.maximumTurns());
        if (scene.field().isPresent()) {
            writeField(out, scene.field().get());
        }
    }

    private static void writeField(JsonGenerator out, Field field) {
        out.writeObjectPropertyStart("field");
        if (field.x() != 0 || field.y() != 0) {
            JsonNumbers.write(out, "x", field.x());
            JsonNumbers.write(out, "y", field.y());
        }
        JsonNumbers.write(out, "width", field.width());
        JsonNumbers.write(out, "height", field.height());
        out.writeBooleanProperty("walls", !field.walls().isEmpty());
        JsonObject.writeAll(out, "bumpers", field.bumpers(), bumper -> {
            JsonNumbers.write(out, "x", bumper.x());
            JsonNumbers.write(out, "y", bumper.y());
            JsonNumbers.write(out, "radius", bumper.radius());
        });
        out.writeEndObject();
    }

    @Override
    public void writeTurn(JsonGenerator out, int player) {
        JsonNumbers.write(out, Name.TURNS_LEFT, race.turnsLeft(player));
        out.writeName(Name.PODS);
        out.writeStartArray();
        for (int pod = 0; pod < race.settings().pods(); pod++) {
            out.writeRawValue(texts.view(pod, race.playerOf(pod) == player));
        }
        out.writeEndArray();
    }

    @Override
    public String readAnswer(int player, byte[] line, int length) {
        messages[player] = null;
        String wrong = answer.read(line, length);
        if (wrong == null) {
            messages[player] = answer.message();
            answer.command(race, player, race.settings().podsPerPlayer());
        }
        return wrong;
    }

    @Override
    public String message(int player) {
        return messages[player];
    }
}
