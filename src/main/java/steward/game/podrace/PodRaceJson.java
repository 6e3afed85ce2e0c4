package steward.game.podrace;

import steward.game.FrameCodec;
import steward.game.JsonNumbers;
import steward.game.WallJson;
import steward.physics.Bodies;
import steward.scene.Bumper;
import steward.scene.Field;
import steward.scene.Scene;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.JsonParser;
import tools.jackson.core.io.SerializedString;

/** The frames of the pod race, its state in replays and its drawing, as JSON. Answers are read by {@link PodAnswer}. */
final class PodRaceJson implements FrameCodec {

    private static final double HALF_TURN_DEGREES = 180;
    private static final double FULL_TURN_DEGREES = 360;

    /** The names that every turn writes, encoded once. */
    private static final class Name {
        static final SerializedString TURNS_LEFT = new SerializedString("turnsLeft");
        static final SerializedString NEXT_CHECKPOINT = new SerializedString("nextCheckpoint");
        static final SerializedString LAP = new SerializedString("lap");
        static final SerializedString SHIELD_TIMER = new SerializedString("shieldTimer");
        static final SerializedString ID = new SerializedString("id");
        static final SerializedString PLAYER = new SerializedString("player");
        static final SerializedString BOOST_LEFT = new SerializedString("boostLeft");
        static final SerializedString HEADING = new SerializedString("heading");
        static final SerializedString X = new SerializedString("x");
        static final SerializedString Y = new SerializedString("y");
        static final SerializedString VX = new SerializedString("vx");
        static final SerializedString VY = new SerializedString("vy");
        static final SerializedString PODS = new SerializedString("pods");
        static final SerializedString THRUST = new SerializedString("thrust");
        static final SerializedString SHIELD = new SerializedString("shield");
        static final SerializedString BOOST = new SerializedString("boost");
        static final SerializedString PASSED = new SerializedString("passed");
        static final SerializedString BODIES = new SerializedString("bodies");
    }

    private final PodRace race;
    private final Scene scene;
    private final PodAnswer answer;
    private final String[] messages;

    PodRaceJson(PodRace race, Scene scene) {
        this.race = race;
        this.scene = scene;
        answer = new PodAnswer(race.settings().podsPerPlayer(), race.settings().maximumThrust());
        messages = new String[race.players()];
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
            out.writeStartObject();
            writeMotion(out, pod);
            JsonNumbers.writeOrNull(out, Name.HEADING, degrees(race.heading(pod)));
            JsonNumbers.write(out, Name.NEXT_CHECKPOINT, race.nextCheckpoint(pod));
            JsonNumbers.write(out, Name.LAP, race.lap(pod));
            if (race.playerOf(pod) == player) {
                JsonNumbers.write(out, Name.SHIELD_TIMER, race.shieldTimer(pod));
                JsonNumbers.write(out, Name.BOOST_LEFT, race.boostLeft(pod));
            }
            out.writeEndObject();
        }
        out.writeEndArray();
    }

    private void writeMotion(JsonGenerator out, int pod) {
        Bodies bodies = race.bodies();
        JsonNumbers.write(out, Name.ID, bodies.id(pod));
        JsonNumbers.write(out, Name.PLAYER, race.playerOf(pod));
        JsonNumbers.write(out, Name.X, bodies.x[pod]);
        JsonNumbers.write(out, Name.Y, bodies.y[pod]);
        JsonNumbers.write(out, Name.VX, bodies.vx[pod]);
        JsonNumbers.write(out, Name.VY, bodies.vy[pod]);
    }

    /** A heading as bots see it: degrees in [0, 360), NaN while unset. */
    static double degrees(double radians) {
        double degrees = radians * HALF_TURN_DEGREES / Math.PI % FULL_TURN_DEGREES;
        double wrapped = degrees < 0 ? degrees + FULL_TURN_DEGREES : degrees;
        return wrapped >= FULL_TURN_DEGREES ? 0 : wrapped + 0.0;
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
        int first = player * race.settings().podsPerPlayer();
        out.writeStartArray();
        for (int pod = first; pod < first + race.settings().podsPerPlayer(); pod++) {
            out.writeStartObject();
            JsonNumbers.write(out, Name.X, race.targetX(pod));
            JsonNumbers.write(out, Name.Y, race.targetY(pod));
            switch (race.thrust(pod)) {
                case PodRace.SHIELD -> JsonNumbers.write(out, Name.SHIELD, true);
                case PodRace.BOOST -> JsonNumbers.write(out, Name.BOOST, true);
                default -> JsonNumbers.write(out, Name.THRUST, race.thrust(pod));
            }
            out.writeEndObject();
        }
        out.writeEndArray();
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
            out.writeStartObject();
            writeMotion(out, pod);
            JsonNumbers.writeOrNull(out, Name.HEADING, race.heading(pod));
            JsonNumbers.write(out, Name.SHIELD_TIMER, race.shieldTimer(pod));
            JsonNumbers.write(out, Name.BOOST_LEFT, race.boostLeft(pod));
            JsonNumbers.write(out, Name.PASSED, race.passed(pod));
            out.writeEndObject();
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

    /** What to show: the scene's field, or the official 16000 x 9000 grown to hold every checkpoint. */
    private double[] frame() {
        if (scene.field().isPresent()) {
            return new double[] {0, 0, scene.field().get().width(), scene.field().get().height()};
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
