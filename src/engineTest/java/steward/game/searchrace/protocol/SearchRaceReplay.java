package steward.game.searchrace.protocol;

import java.util.ArrayList;
import java.util.List;
import steward.game.TurnEvent;
import steward.game.VectorMatch;
import steward.game.VectorReplay;
import steward.game.searchrace.SearchRace;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;

/** A match of the published Search Race referee, played again. */
public final class SearchRaceReplay extends VectorReplay<SearchRace> {

    /** The score of a race that is not won. */
    private static final double LOST = 1000;

    private boolean alone;

    public SearchRaceReplay(VectorMatch match) {
        super(match, SearchRaces.map(match.header().get("map").asString()));
    }

    @Override
    protected SearchRace create() {
        return ((SearchRaceType.SearchRaceSetup) setup).create(1);
    }

    @Override
    protected SearchRace in(SearchRace fresh, JsonNode state) {
        SearchRace race = create();
        race.set(state.get("x").asDouble(), state.get("y").asDouble(), state.get("vx").asDouble(),
            state.get("vy").asDouble(), state.get("angle").asDouble(), state.get("checkpoint").asInt(),
            state.get("timer").asInt(), state.get("colTime").asDouble());
        if (state.get("debug").asBoolean()) {
            race.askForTimes();
        }
        return race;
    }

    @Override
    protected void compareTurn(String when, JsonNode turn, SearchRace race) {
        alone = when.endsWith(" alone");
        super.compareTurn(when, turn, race);
    }

    /**
     * The lines of its one player; those before the first turn stand in the header. What a line tells of the turn
     * before is not in a recorded state.
     */
    @Override
    protected JsonNode inputs(JsonNode turn) {
        if (alone) {
            return null;
        }
        ArrayNode inputs = JsonNodeFactory.instance.arrayNode();
        ArrayNode lines = inputs.addArray();
        if (turn.get("turn").asInt() == 1) {
            match.header().get("initInput").forEach(lines::add);
        }
        turn.get("input").forEach(lines::add);
        return inputs;
    }

    @Override
    protected JsonNode commands(JsonNode turn) {
        ArrayNode commands = JsonNodeFactory.instance.arrayNode();
        if (turn.get("command").isNull()) {
            return commands.add("TIMEOUT");
        }
        commands.addArray().add(turn.get("command"));
        return commands;
    }

    @Override
    protected void compareImpacts(String when, JsonNode turn, SearchRace race) {
        comparison.same(when + " valid", !turn.has("fault"), race.isIn(0));
        if (!turn.has("fault")) {
            comparison.same(when + " done", turn.get("state").get("done").asBoolean(), race.isOver());
            List<Double> passTimes = new ArrayList<>();
            turn.get("passTimes").forEach(time -> passTimes.add(time.asDouble()));
            comparison.same(when + " pass times", passTimes, race.events().stream().map(TurnEvent::time).toList());
        }
    }

    /** Before the first turn that referee has the initial value of a pass time, which it never shows. */
    @Override
    protected void compareState(String when, JsonNode state, SearchRace race) {
        boolean start = when.equals("turn 0");
        comparison.fields(when + " ", state, "x", race.bodies().x[0], "y", race.bodies().y[0],
            "vx", race.bodies().vx[0], "vy", race.bodies().vy[0], "angle", race.heading(),
            "checkpoint", race.passed(), "timer", race.timer());
        comparison.same(when + " pass time", start ? 0.0 : state.get("colTime").asDouble(),
            start ? 0.0 : race.passTime());
        comparison.same(when + " debug", state.get("debug").asBoolean(), race.wantsTimes());
    }

    @Override
    protected Object score(SearchRace race, int player) {
        return race.scores()[player];
    }

    @Override
    protected void compareEnd(SearchRace race) {
        comparison.same("over", true, race.isOver());
        comparison.same("turns", match.end().get("turnsPlayed").asInt(), race.turn());
        comparison.same("won", match.end().get("won").asBoolean(), race.scores()[0] < LOST);
        comparison.same("time", match.end().get("time").asDouble(), race.scores()[0]);
    }
}
