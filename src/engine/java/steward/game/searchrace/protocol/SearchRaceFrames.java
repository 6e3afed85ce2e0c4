package steward.game.searchrace.protocol;

import java.util.List;
import steward.game.BotFrames;
import steward.game.searchrace.OfficialSearchRace;
import steward.game.searchrace.SearchRace;
import steward.game.searchrace.SearchRaceSettings;
import steward.json.DrawingJson;
import steward.json.JsonNumbers;
import steward.json.JsonObject;
import steward.scene.Scene;
import tools.jackson.core.JsonGenerator;

/** JSON frames that bots of the search race are sent; answers are read by {@link SearchRaceAnswer}. */
final class SearchRaceFrames implements BotFrames {

    private final SearchRace race;
    private final Scene scene;
    private final SearchRaceAnswer answer = SearchRaceAnswer.ofBot();
    private String message;

    SearchRaceFrames(SearchRace race, Scene scene) {
        this.race = race;
        this.scene = scene;
    }

    @Override
    public void writeSetup(JsonGenerator out, int player) {
        SearchRaceSettings settings = race.settings();
        out.writeNumberProperty("laps", settings.laps());
        JsonObject.writeEach(out, "checkpoints", List.of(race.checkpoints()),
            checkpoint -> DrawingJson.place(out, checkpoint[0], checkpoint[1]));
        JsonNumbers.write(out, "checkpointRadius", settings.checkpointRadius());
        out.writeNumberProperty("maximumThrust", SearchRaceSettings.MAXIMUM_THRUST);
        out.writeNumberProperty("maximumTurn", SearchRaceSettings.MAXIMUM_TURN);
        JsonNumbers.write(out, "drag", scene.drag());
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
        message = null;
        String wrong = answer.read(line, length);
        if (wrong == null) {
            message = answer.message();
            answer.command(race);
        }
        return wrong;
    }

    @Override
    public String message(int player) {
        return message;
    }
}
