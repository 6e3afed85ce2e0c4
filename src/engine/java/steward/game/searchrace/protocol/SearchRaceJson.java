package steward.game.searchrace.protocol;

import java.util.List;
import steward.game.GameJson;
import steward.game.searchrace.OfficialSearchRace;
import steward.game.searchrace.SearchRace;
import steward.game.searchrace.SearchRaceSettings;
import steward.json.DrawingJson;
import steward.json.JsonNumbers;
import steward.json.JsonObject;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.JsonParser;

/** JSON of the search race: frames, commands, states and drawing; {@link SearchRaceAnswer} reads answers. */
public final class SearchRaceJson implements GameJson {

    private static final double WIDTH = 16_000;
    private static final double HEIGHT = 9000;
    /** The size at which the car, a point, is drawn. */
    private static final double MARK = 250;

    private final SearchRace race;
    private final double drag;
    private final SearchRaceAnswer answer = SearchRaceAnswer.ofBot();
    private final SearchRaceAnswer command = SearchRaceAnswer.ofReplay();
    private String message;

    SearchRaceJson(SearchRace race, double drag) {
        this.race = race;
        this.drag = drag;
    }

    /**
     * State of a race.
     *
     * @param passTime when the last checkpoint of the turn was passed, 2 if none was
     * @param debug    whether the car is told such times
     */
    public record State(List<Car> bodies, int timer, double passTime, boolean debug) { }

    /** The car. @param heading in radians */
    public record Car(int id, double x, double y, double vx, double vy, int player, double heading, int passed) { }

    @Override
    public void writeSetup(JsonGenerator out, int player) {
        SearchRaceSettings settings = race.settings();
        out.writeNumberProperty("laps", settings.laps());
        JsonObject.writeEach(out, "checkpoints", List.of(race.checkpoints()),
            checkpoint -> DrawingJson.place(out, checkpoint[0], checkpoint[1]));
        JsonNumbers.write(out, "checkpointRadius", settings.checkpointRadius());
        out.writeNumberProperty("maximumThrust", SearchRaceSettings.MAXIMUM_THRUST);
        out.writeNumberProperty("maximumTurn", SearchRaceSettings.MAXIMUM_TURN);
        JsonNumbers.write(out, "drag", drag);
        out.writeNumberProperty("maximumTurns", settings.maximumTurns());
    }

    @Override
    public void writeTurn(JsonGenerator out, int player) {
        out.writeObjectPropertyStart("car");
        JsonNumbers.write(out, "x", race.bodies().x[0]);
        JsonNumbers.write(out, "y", race.bodies().y[0]);
        JsonNumbers.write(out, "vx", race.bodies().vx[0]);
        JsonNumbers.write(out, "vy", race.bodies().vy[0]);
        out.writeNumberProperty("heading", OfficialSearchRace.degrees(race.heading()));
        out.writeNumberProperty("passed", race.passed());
        out.writeNumberProperty("nextCheckpoint", race.nextCheckpoint());
        JsonNumbers.writeOrNull(out, "passTime",
            race.passTime() == SearchRace.NOT_PASSED ? Double.NaN : race.passTime());
        out.writeEndObject();
    }

    @Override
    public String readAnswer(int player, byte[] line, int length) {
        String wrong = answer.read(line, length);
        message = wrong == null ? answer.message() : null;
        if (wrong == null) {
            answer.command(race);
        }
        return wrong;
    }

    @Override
    public String message(int player) {
        return message;
    }

    @Override
    public void writeCommand(JsonGenerator out, int player) {
        out.writeStartObject();
        if (race.order() == SearchRace.Order.TURN) {
            out.writeNumberProperty("turn", race.degrees());
        } else {
            JsonNumbers.write(out, "x", race.targetX());
            JsonNumbers.write(out, "y", race.targetY());
        }
        out.writeNumberProperty("thrust", race.thrust());
        if (race.asksForTimes()) {
            out.writeBooleanProperty("debug", true);
        }
        out.writeEndObject();
    }

    @Override
    public String readCommand(JsonParser in, int player) {
        String wrong = command.readObject(in);
        if (wrong == null) {
            command.command(race);
        }
        return wrong;
    }

    @Override
    public void clearCommand(int player) {
        race.clear();
    }

    @Override
    public void writeState(JsonGenerator out) {
        out.writeArrayPropertyStart("bodies");
        out.writeStartObject();
        DrawingJson.motion(out, race.bodies(), 0);
        out.writeNumberProperty("player", 0);
        JsonNumbers.write(out, "heading", race.heading());
        out.writeNumberProperty("passed", race.passed());
        out.writeEndObject();
        out.writeEndArray();
        out.writeNumberProperty("timer", race.timer());
        JsonNumbers.write(out, "passTime", race.passTime());
        out.writeBooleanProperty("debug", race.wantsTimes());
    }

    @Override
    public void writeDrawing(JsonGenerator out) {
        double[][] checkpoints = race.checkpoints();
        DrawingJson.course(out, WIDTH, HEIGHT, checkpoints);
        DrawingJson.checkpoints(out, checkpoints, race.settings().checkpointRadius());
        out.writeArrayPropertyStart("bodies");
        DrawingJson.body(out, race.bodies().id(0), "car", MARK, 0, "");
        out.writeEndArray();
    }
}
