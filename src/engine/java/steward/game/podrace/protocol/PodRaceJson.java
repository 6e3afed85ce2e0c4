package steward.game.podrace.protocol;

import java.util.List;
import steward.game.GameJson;
import steward.game.podrace.PodRace;
import steward.game.podrace.PodRaceSettings;
import steward.game.podrace.RulesEdition;
import steward.json.DrawingJson;
import steward.json.JsonNumbers;
import steward.json.JsonObject;
import steward.json.WallJson;
import steward.physics.Bodies;
import steward.scene.Field;
import steward.scene.Scene;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.JsonParser;
import tools.jackson.core.io.SerializedString;

/**
 * JSON of the pod race: frames, commands, states and drawing. {@link PodRaceAnswer} reads answers, and {@link
 * PodJsonCache} has the texts of pods and commands.
 */
public final class PodRaceJson implements GameJson {

    /** The size of the field where the scene has none: that of the site. */
    private static final double WIDTH = 16_000;
    private static final double HEIGHT = 9000;
    private static final SerializedString TURNS_LEFT = new SerializedString("turnsLeft");
    private static final SerializedString PODS = new SerializedString("pods");
    private static final SerializedString BODIES = new SerializedString("bodies");

    private final PodRace race;
    private final PodRaceSettings settings;
    private final Scene scene;
    private final PodRaceAnswer answer;
    private final PodRaceAnswer recorded;
    private final PodJsonCache texts;
    private final String[] messages;

    PodRaceJson(PodRace race, Scene scene) {
        this.race = race;
        this.scene = scene;
        settings = race.settings();
        texts = new PodJsonCache(race);
        answer = new PodRaceAnswer(settings.podsPerPlayer(), settings.maximumThrust());
        recorded = new PodRaceAnswer(settings.podsPerPlayer(), settings.maximumThrust());
        messages = new String[race.players()];
    }

    /** State of a race. @param turnsLeft per player, until the next checkpoint has to be passed */
    public record State(List<Pod> bodies, int[] turnsLeft) { }

    /**
     * A pod.
     *
     * @param heading in radians, never normalised; {@code null} before the first command that turns
     * @param passed  checkpoints since the start
     */
    public record Pod(int id, int player, double x, double y, double vx, double vy, Double heading, int shieldTimer,
                      boolean boostLeft, int passed) { }

    @Override
    public void writeSetup(JsonGenerator out, int player) {
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
        scene.field().ifPresent(field -> writeField(out, field));
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
        JsonNumbers.write(out, TURNS_LEFT, race.turnsLeft(player));
        out.writeName(PODS);
        out.writeStartArray();
        for (int pod = 0; pod < settings.pods(); pod++) {
            out.writeRawValue(texts.view(pod, race.playerOf(pod) == player));
        }
        out.writeEndArray();
    }

    @Override
    public String readAnswer(int player, byte[] line, int length) {
        String wrong = answer.read(line, length);
        messages[player] = wrong == null ? answer.message() : null;
        return take(player, wrong, answer, settings.podsPerPlayer());
    }

    private String take(int player, String wrong, PodRaceAnswer read, int pods) {
        if (wrong == null) {
            read.command(race, player, pods);
        }
        return wrong;
    }

    @Override
    public String message(int player) {
        return messages[player];
    }

    @Override
    public void writeCommand(JsonGenerator out, int player) {
        out.writeRawValue(texts.command(player));
    }

    @Override
    public boolean hasPartialCommand(int player) {
        return race.thrust(player * settings.podsPerPlayer()) != PodRace.NO_COMMAND;
    }

    @Override
    public void clearCommand(int player) {
        int first = player * settings.podsPerPlayer();
        for (int k = 0; k < settings.podsPerPlayer(); k++) {
            race.command(first + k, 0, 0, PodRace.NO_COMMAND);
        }
    }

    @Override
    public String readPartialCommand(JsonParser in, int player) {
        String wrong = recorded.readArray(in, true);
        return take(player, wrong, recorded, recorded.given());
    }

    @Override
    public String readCommand(JsonParser in, int player) {
        return take(player, recorded.readArray(in, false), recorded, settings.podsPerPlayer());
    }

    @Override
    public int readPlainCommand(byte[] json, int from, int to, int player) {
        int behind = recorded.readPlainPods(json, from, to);
        if (behind >= 0) {
            recorded.command(race, player, settings.podsPerPlayer());
        }
        return behind;
    }

    @Override
    public void writeState(JsonGenerator out) {
        out.writeName(BODIES);
        out.writeStartArray();
        for (int pod = 0; pod < settings.pods(); pod++) {
            out.writeRawValue(texts.state(pod));
        }
        out.writeEndArray();
        out.writeName(TURNS_LEFT);
        out.writeStartArray();
        for (int player = 0; player < race.players(); player++) {
            out.writeNumber(race.turnsLeft(player));
        }
        out.writeEndArray();
    }

    @Override
    public void writeDrawing(JsonGenerator out) {
        double[][] checkpoints = race.checkpoints();
        if (scene.field().isPresent()) {
            Field field = scene.field().get();
            DrawingJson.field(out, field.x(), field.y(), field.width(), field.height());
            WallJson.write(out, field.walls());
        } else {
            DrawingJson.course(out, WIDTH, HEIGHT, checkpoints);
        }
        DrawingJson.checkpoints(out, checkpoints, settings.checkpointRadius());
        Bodies bodies = race.bodies();
        JsonObject.writeEach(out, "bodies", bodies.size(), body -> {
            if (body < settings.pods()) {
                DrawingJson.body(out, bodies.id(body), "pod", bodies.radius[body], race.playerOf(body),
                    Integer.toString(body));
            } else {
                DrawingJson.fixedBody(out, bodies, body, "bumper");
            }
        });
    }
}
