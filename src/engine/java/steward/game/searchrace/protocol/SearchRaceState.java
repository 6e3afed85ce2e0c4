package steward.game.searchrace.protocol;

import steward.game.StateCodec;
import steward.game.searchrace.SearchRace;
import steward.json.DrawingJson;
import steward.json.JsonNumbers;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.JsonParser;

/** The commands and states of the search race, as a replay keeps them. */
final class SearchRaceState implements StateCodec {

    private final SearchRace race;
    private final SearchRaceAnswer command = SearchRaceAnswer.ofReplay();

    SearchRaceState(SearchRace race) {
        this.race = race;
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
}
