package steward.codingame;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.util.ArrayList;
import java.util.List;
import java.util.function.IntFunction;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import steward.match.MatchResult;
import steward.match.TestScenes;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** The game result in JSON, field by field. */
class GameResultLogTest {

    private static final List<String> FIELDS = List.of("errors", "outputs", "summaries", "views", "scores", "uinput",
        "metadata", "tooltips", "ids", "agents");

    private MatchResult result;

    private JsonNode play(IntFunction<String> stderr, int... fails) throws InterruptedException {
        GameResultLog log = new GameResultLog();
        result = TextPilot.play(TestScenes.open("mad-pod-racing"), log, stderr, fails);
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        log.write(bytes, "mad-pod-racing", 7, result);
        return JsonMapper.shared().readTree(bytes.toByteArray());
    }

    @Test
    void everyListHasTheStartAndEachTurn() throws InterruptedException {
        JsonNode json = play(turn -> turn % 2 == 0 ? null : "turn " + turn + "\n[PDATA] k = 1\n", 0, 0);

        assertEquals(FIELDS, new ArrayList<>(json.propertyNames()));
        int entries = result.turns() + 1;
        for (String streams : List.of("errors", "outputs")) {
            assertEquals(List.of("referee", "0", "1"), new ArrayList<>(json.get(streams).propertyNames()));
            json.get(streams).forEach(list -> {
                assertEquals(entries, list.size());
                assertTrue(list.get(0).isNull());
            });
        }
        assertEquals(entries, json.get("summaries").size());
        assertEquals(entries, json.get("views").size());
        String output = json.get("outputs").get("0").get(1).asString();
        assertTrue(output.matches("(\\d+ \\d+ 100 turn 1\n){2}"), output);
        assertEquals("turn 3\n[PDATA] k = 1\n", json.get("errors").get("0").get(3).asString());
        assertTrue(json.get("errors").get("0").get(2).isNull());
        assertTrue(json.get("errors").get("1").get(1).isNull());
        assertTrue(json.get("outputs").get("referee").get(1).isNull());
        assertEquals(4, JsonMapper.shared().readTree(json.get("views").get(0).asString()).get("bodies").size());
        assertEquals(0, json.get("tooltips").size());
    }

    @Test
    void playersAndSeedAreNamed() throws InterruptedException {
        JsonNode json = play(turn -> null, 3, 0);

        assertEquals("[\"seed=7\"]", json.get("uinput").toString());
        assertEquals("{\"0\":-1,\"1\":1}", json.get("scores").toString());
        assertEquals("{\"0\":0,\"1\":1}", json.get("ids").toString());
        assertEquals("[{\"index\":0,\"name\":\"pilot-0\"},{\"index\":1,\"name\":\"pilot-1\"}]",
            json.get("agents").toString());
        assertEquals("{\"scene\":\"mad-pod-racing\",\"turns\":3,\"ending\":\"all others are out\"}",
            json.get("metadata").asString());
    }

    @Test
    void aFaultShowsWhatCameAndWhy() throws InterruptedException {
        JsonNode json = play(turn -> null, 0, 2);

        assertEquals("nonsense\nnonsense\n", json.get("outputs").get("1").get(2).asString());
        String summary = json.get("summaries").get(2).asString();
        assertTrue(summary.startsWith("player 1 is out: line 1 of 2: found \"nonsense\""), summary);
        assertEquals(1, json.get("tooltips").size());
        assertEquals(2, json.get("tooltips").get(0).get("event").intValue());
        assertEquals(summary.strip(), json.get("tooltips").get(0).get("text").asString());
    }

    @Test
    @Tag("slow")
    void memoryIsBounded() throws InterruptedException {
        String much = "x".repeat(GameResultLog.MOST_CHARACTERS / 4);
        JsonNode errors = play(turn -> much, 8, 0).get("errors").get("0");

        int kept = 0;
        for (JsonNode entry : errors) {
            kept += entry.isNull() ? 0 : 1;
        }
        assertEquals(9, errors.size());
        assertEquals(4, kept);
    }
}
