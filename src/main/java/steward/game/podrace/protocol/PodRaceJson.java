package steward.game.podrace.protocol;

import steward.game.FrameCodec;
import steward.game.JsonNumbers;
import steward.game.WallJson;
import steward.game.podrace.PodRace;
import steward.game.podrace.PodRaceSettings;
import steward.physics.Bodies;
import steward.scene.Bumper;
import steward.scene.Field;
import steward.scene.Scene;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.JsonParser;
import tools.jackson.core.io.SerializedString;

/** The frames of the pod race, its state in replays and its drawing, as JSON. Answers are read by {@link PodAnswer}. */
final class PodRaceJson implements FrameCodec {

    /** The names that every turn writes, encoded once. */
    private static final class Name {
        static final SerializedString TURNS_LEFT = new SerializedString("turnsLeft");
        static final SerializedString PODS = new SerializedString("pods");
        static final SerializedString BODIES = new SerializedString("bodies");
    }

    private final PodRace race;
    private final Scene scene;
    private final PodAnswer answer;
    private final PodJsonCache texts;
    private final String[] messages;

    PodRaceJson(PodRace race, Scene scene) {
        this.race = race;
        this.scene = scene;
        answer = new PodAnswer(race.settings().podsPerPlayer(), race.settings().maximumThrust());
        messages = new String[race.players()];
        texts = new PodJsonCache(race);
    }

    @Override
    public void writeSetup(JsonGenerator out, int player) {
        PodRaceSettings settings = race.settings();
        out.writeNumberProperty("podsPerPlayer", settings.podsPerPlayer());
        out.writeNumberProperty("laps", settings.laps());
        out.writeArrayPropertyStart("checkpoints");
        for (double[] checkpoint : race.checkpoints()) {
            out.writeStartObject();
            JsonNumbers.write(out, "x", checkpoint[0]);
            JsonNumbers.write(out, "y", checkpoint[1]);
            out.writeEndObject();
        }
        out.writeEndArray();
        JsonNumbers.write(out, "checkpointRadius", settings.checkpointRadius());
        JsonNumbers.write(out, "podRadius", settings.radius());
        JsonNumbers.write(out, "podMass", settings.mass());
        JsonNumbers.write(out, "minimumImpulse", scene.law().minimumImpulse());
        JsonNumbers.write(out, "drag", scene.drag());
        out.writeNumberProperty("maximumThrust", settings.maximumThrust());
        out.writeNumberProperty("boostThrust", PodRaceSettings.BOOST_THRUST);
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
        out.writeArrayPropertyStart("bumpers");
        for (Bumper bumper : field.bumpers()) {
            out.writeStartObject();
            JsonNumbers.write(out, "x", bumper.x());
            JsonNumbers.write(out, "y", bumper.y());
            JsonNumbers.write(out, "radius", bumper.radius());
            out.writeEndObject();
        }
        out.writeEndArray();
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
            int first = player * race.settings().podsPerPlayer();
            for (int k = 0; k < race.settings().podsPerPlayer(); k++) {
                race.command(first + k, answer.x(k), answer.y(k), answer.thrust(k));
            }
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
        return race.thrust(player * race.settings().podsPerPlayer()) != PodRace.NO_COMMAND;
    }

    @Override
    public void clearCommand(int player) {
        int first = player * race.settings().podsPerPlayer();
        for (int k = 0; k < race.settings().podsPerPlayer(); k++) {
            race.command(first + k, 0, 0, PodRace.NO_COMMAND);
        }
    }

    @Override
    public String readPartialCommand(JsonParser in, int player) {
        String wrong = answer.readFirstPods(in);
        if (wrong == null) {
            int first = player * race.settings().podsPerPlayer();
            for (int k = 0; k < answer.podsRead(); k++) {
                race.command(first + k, answer.x(k), answer.y(k), answer.thrust(k));
            }
        }
        return wrong;
    }

    @Override
    public String readCommand(JsonParser in, int player) {
        String wrong = answer.readPods(in);
        if (wrong == null) {
            int first = player * race.settings().podsPerPlayer();
            for (int k = 0; k < race.settings().podsPerPlayer(); k++) {
                race.command(first + k, answer.x(k), answer.y(k), answer.thrust(k));
            }
        }
        return wrong;
    }

    @Override
    public void writeState(JsonGenerator out) {
        out.writeName(Name.BODIES);
        out.writeStartArray();
        for (int pod = 0; pod < race.settings().pods(); pod++) {
            out.writeRawValue(texts.state(pod));
        }
        out.writeEndArray();
        out.writeName(Name.TURNS_LEFT);
        out.writeStartArray();
        for (int player = 0; player < race.players(); player++) {
            out.writeNumber(race.turnsLeft(player));
        }
        out.writeEndArray();
    }

    @Override
    public void writeDrawing(JsonGenerator out) {
        double[] frame = frame();
        out.writeObjectPropertyStart("field");
        JsonNumbers.write(out, "x", frame[0]);
        JsonNumbers.write(out, "y", frame[1]);
        JsonNumbers.write(out, "width", frame[2]);
        JsonNumbers.write(out, "height", frame[3]);
        out.writeEndObject();
        scene.field().ifPresent(field -> WallJson.write(out, field.walls()));
        out.writeArrayPropertyStart("zones");
        double[][] checkpoints = race.checkpoints();
        for (int k = 0; k < checkpoints.length; k++) {
            out.writeStartObject();
            JsonNumbers.write(out, "x", checkpoints[k][0]);
            JsonNumbers.write(out, "y", checkpoints[k][1]);
            JsonNumbers.write(out, "radius", race.settings().checkpointRadius());
            out.writeStringProperty("label", Integer.toString(k));
            out.writeEndObject();
        }
        out.writeEndArray();
        out.writeArrayPropertyStart("bodies");
        Bodies bodies = race.bodies();
        for (int body = 0; body < bodies.size(); body++) {
            boolean pod = body < race.settings().pods();
            out.writeStartObject();
            out.writeNumberProperty("id", bodies.id(body));
            out.writeStringProperty("kind", pod ? "pod" : "bumper");
            JsonNumbers.write(out, "radius", bodies.radius[body]);
            if (pod) {
                out.writeNumberProperty("owner", race.playerOf(body));
                out.writeStringProperty("label", Integer.toString(body));
            } else {
                JsonNumbers.write(out, "x", bodies.x[body]);
                JsonNumbers.write(out, "y", bodies.y[body]);
            }
            out.writeEndObject();
        }
        out.writeEndArray();
    }

    /** The area to draw: the scene's field, or the official 16000 x 9000, enlarged to contain every checkpoint. */
    private double[] frame() {
        if (scene.field().isPresent()) {
            Field field = scene.field().get();
            return new double[] {field.x(), field.y(), field.width(), field.height()};
        }
        double right = 16000;
        double bottom = 9000;
        double left = 0;
        double top = 0;
        for (double[] checkpoint : race.checkpoints()) {
            left = Math.min(left, checkpoint[0]);
            top = Math.min(top, checkpoint[1]);
            right = Math.max(right, checkpoint[0]);
            bottom = Math.max(bottom, checkpoint[1]);
        }
        return new double[] {left, top, right - left, bottom - top};
    }
}
