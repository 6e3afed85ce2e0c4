package steward.game.searchrace.protocol;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.zip.GZIPInputStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.game.Comparison;
import steward.game.GroundTruth;
import steward.game.TextCodec;
import steward.game.TurnEvent;
import steward.game.searchrace.SearchRace;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * Whole matches of the published referee with correctly rounded sine and cosine, free-running from the start and from
 * the recorded state before each turn; and games of the server. Another folder: {@code gradle test --tests
 * '*VectorsTest' -Psteward.vectors=FOLDER -Psteward.recordings=FOLDER}.
 */
@Execution(ExecutionMode.CONCURRENT)
class SearchRaceVectorsTest {

    private static final String GAME = "search-race";

    private static List<JsonNode> read(Path file) throws IOException {
        List<JsonNode> lines = new ArrayList<>();
        try (BufferedReader in = new BufferedReader(new InputStreamReader(
                new GZIPInputStream(Files.newInputStream(file)), StandardCharsets.UTF_8))) {
            in.lines().forEach(line -> lines.add(JsonMapper.shared().readTree(line)));
        }
        return lines;
    }

    @Test
    void matchesOfTheRefereeAreReproducedToTheLastBit(TestReporter report) throws IOException {
        compare(report, false);
    }

    @Test
    @Tag("campaign")
    void everyMatchOfTheRefereeIsReproducedToTheLastBit(TestReporter report) throws IOException {
        compare(report, true);
    }

    private static void compare(TestReporter report, boolean all) throws IOException {
        List<String> differences = new ArrayList<>();
        long values = 0;
        int turns = 0;
        List<Path> files = GroundTruth.VECTORS.files(all, GAME, ".jsonl.gz");
        for (Path file : files) {
            List<JsonNode> lines = read(file);
            Comparison free = compareFree(file.getFileName().toString(), lines);
            Comparison each = compareEach(file.getFileName() + " (turn by turn)", lines);
            values += free.values() + each.values();
            turns += lines.size() - 3;
            differences.addAll(free.differences());
            differences.addAll(each.differences());
        }
        GroundTruth.tell(report, GAME + ": " + files.size() + " matches, " + turns + " turns, free and turn by turn, "
            + values + " values compared, " + differences.size() + " different");

        assertTrue(values > 0, "the folder holds matches");
        assertEquals(List.of(), differences.stream().limit(20).toList());
    }

    /** From the start to the end, without looking at a recorded state. */
    private static Comparison compareFree(String name, List<JsonNode> lines) {
        Comparison found = new Comparison(name);
        SearchRace race = SearchRaces.onMap(lines.get(0).get("map").asString());
        TextCodec codec = new SearchRaceText(race);
        StringBuilder sent = new StringBuilder();
        codec.writeSetup(sent, 0);
        found.same("setup", lines(lines.get(0).get("initInput")), sent.toString());
        compareState(found, "turn 0", lines.get(1).get("state"), race);
        for (JsonNode turn : lines.subList(2, lines.size() - 1)) {
            String when = "turn " + turn.get("turn").asInt();
            if (race.isOver()) {
                found.same(when, "a turn", "over: " + race.ending());
                return found;
            }
            sent.setLength(0);
            codec.writeTurn(sent, 0);
            found.same(when + " input", lines(turn.get("input")), sent.toString());
            play(found, when, turn, race, codec);
        }
        JsonNode end = lines.get(lines.size() - 1);
        if (!end.get("truncated").asBoolean()) {
            found.same("over", true, race.isOver());
            found.same("turns", end.get("turnsPlayed").asInt(), race.turn());
            found.same("won", end.get("won").asBoolean(), race.scores()[0] < 1000);
            found.same("time", end.get("time").asDouble(), race.scores()[0]);
        }
        return found;
    }

    /** Each turn alone, from the recorded state before it. */
    private static Comparison compareEach(String name, List<JsonNode> lines) {
        Comparison found = new Comparison(name);
        JsonNode before = lines.get(1).get("state");
        SearchRaceType.SearchRaceSetup setup = SearchRaces.map(lines.get(0).get("map").asString());
        for (JsonNode turn : lines.subList(2, lines.size() - 1)) {
            SearchRace race = setup.create(1);
            race.set(before.get("x").asDouble(), before.get("y").asDouble(), before.get("vx").asDouble(),
                before.get("vy").asDouble(), before.get("angle").asDouble(), before.get("checkpoint").asInt(),
                before.get("timer").asInt(), before.get("colTime").asDouble());
            if (before.get("debug").asBoolean()) {
                race.askForTimes();
            }
            play(found, "turn " + turn.get("turn").asInt(), turn, race, new SearchRaceText(race));
            before = turn.get("state");
        }
        return found;
    }

    private static void play(Comparison found, String when, JsonNode turn, SearchRace race, TextCodec codec) {
        if (turn.get("command").isNull()) {
            race.eliminate(0, "no answer");
        } else {
            byte[] answer = turn.get("command").asString().getBytes(StandardCharsets.UTF_8);
            String wrong = codec.readAnswer(0, answer, answer.length);
            found.same(when + " valid", !turn.has("fault"), wrong == null);
            if (wrong != null) {
                race.eliminate(0, wrong);
            }
        }
        race.play();
        if (!turn.has("fault")) {
            found.same(when + " done", turn.get("state").get("done").asBoolean(), race.isOver());
            found.same(when + " pass times", doubles(turn.get("passTimes")),
                race.events().stream().map(TurnEvent::time).toList());
        }
        compareState(found, when, turn.get("state"), race);
    }

    private static void compareState(Comparison found, String when, JsonNode state, SearchRace race) {
        found.same(when + " x", state.get("x").asDouble(), race.bodies().x[0]);
        found.same(when + " y", state.get("y").asDouble(), race.bodies().y[0]);
        found.same(when + " vx", state.get("vx").asDouble(), race.bodies().vx[0]);
        found.same(when + " vy", state.get("vy").asDouble(), race.bodies().vy[0]);
        found.same(when + " heading", state.get("angle").asDouble(), race.heading());
        found.same(when + " passed", state.get("checkpoint").asInt(), race.passed());
        found.same(when + " timer", state.get("timer").asInt(), race.timer());
        found.same(when + " pass time", recorded(state, when), race.turn() == 0 ? 0.0 : race.passTime());
        found.same(when + " debug", state.get("debug").asBoolean(), race.wantsTimes());
    }

    /** Before the first turn that referee has the initial value of a field, which it never shows. */
    private static double recorded(JsonNode state, String when) {
        return when.equals("turn 0") ? 0.0 : state.get("colTime").asDouble();
    }

    private static List<Double> doubles(JsonNode list) {
        List<Double> values = new ArrayList<>();
        list.forEach(one -> values.add(one.asDouble()));
        return values;
    }

    private static String lines(JsonNode list) {
        StringBuilder lines = new StringBuilder();
        list.forEach(line -> lines.append(line.asString()).append('\n'));
        return lines.toString();
    }
}
