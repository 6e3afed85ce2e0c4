package steward.schema;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.networknt.schema.Schema;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.bot.Bot;
import steward.bots.BundledBots;
import steward.bots.searchrace.Driver;
import steward.match.TestScenes;
import steward.replay.Recorded;
import steward.scene.SceneReader;
import steward.scene.json.SceneException;

/** The schemas of the search race against real traffic, and against what the reader of scenes says. */
class SearchRaceSchemaTest {

    private static final String GAME = Schemas.SEARCH_RACE;

    private static Schema schemaOf(String line) {
        for (String type : List.of("setup", "turn", "end")) {
            if (line.contains("\"type\":\"" + type + "\"")) {
                return Schemas.open(GAME, type);
            }
        }
        return Schemas.open(GAME, "answer");
    }

    @Test
    void everyLineOfAWholeMatchIsValid() {
        List<String> lines = new ArrayList<>();
        Recorded match = Recorded.of(TestScenes.open("search-race"), 4,
            List.of(BundledBots.of(new Driver(), lines::add)));
        assertEquals(2 * match.result().turns() + 2, lines.size());
        for (String line : lines) {
            assertEquals(List.of(), Schemas.problems(schemaOf(line), line), line);
        }
        Schema replay = Schemas.open(GAME, "replay");
        for (String line : match.lines()) {
            assertEquals(List.of(), Schemas.problems(replay, line), line);
        }
        assertTrue(match.text().contains("\"events\""), "checkpoints were passed");
    }

    /** It turns toward places, asks for times, and fails in turn 5. */
    @Test
    void aMatchWithAFaultIsValid() {
        Recorded match = Recorded.of(TestScenes.open("search-race"), 4, List.of(new Bot() {

            private int turn;

            @Override
            public void setup(String line) {
                turn = 0;
            }

            @Override
            public String turn(String line) {
                return ++turn == 5 ? "left!" : "{\"x\":1.5,\"y\":2,\"thrust\":7,\"message\":\"debug\"}";
            }
        }));
        assertEquals(5, match.result().turns());
        assertEquals(1000, match.result().players().get(0).score());
        Schema replay = Schemas.open(GAME, "replay");
        for (String line : match.lines()) {
            assertEquals(List.of(), Schemas.problems(replay, line), line);
        }
        assertEquals(Recorded.whole(5), match.verify());
    }

    /** Each row: a part of the shipped scene, what stands there instead, and the verdict of both. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
        "by seed"            | "by seed"                        | true
        "by seed"            | 7                                | true
        "by seed"            | 704                              | true
        "by seed"            | 703                              | false
        "by seed"            | "random"                         | false
        "official": "by seed"| "points": [{"x":1,"y":2},{"x":3,"y":4}] | true
        "official": "by seed"| "points": [{"x":1,"y":2},{"x":3,"y":4.5}] | false
        "official": "by seed"| "points": [{"x":1,"y":2}]        | false
        "official": "by seed"| "official": 7, "points": [{"x":1,"y":2},{"x":3,"y":4}] | false
        "official": "by seed"| "maps": 7                        | false
        "players": 1         | "players": 2                     | false
        "maximumTurns": 600  | "maximumTurns": 1001             | false
        "laps": 3            | "laps": 0                        | false
        "map"                | "impacts": {}, "map"             | false
        "map"                | "pods": {}, "map"                | false
        "truncate-snap"      | "truncate"                       | true
        "arithmetic": "official" | "arithmetic": "double"       | true
        """)
    void readerAndSchemaAgree(String part, String instead, boolean valid) {
        String scene = TestScenes.text("search-race");
        assertTrue(scene.contains(part), part);
        String text = scene.replaceFirst(Pattern.quote(part),
            Matcher.quoteReplacement(instead));
        String refusal = null;
        try {
            TestScenes.TYPES.open(SceneReader.read(text, "s.json"));
        } catch (SceneException problem) {
            refusal = problem.getMessage();
        }
        assertEquals(valid, refusal == null, refusal);
        assertEquals(valid, Schemas.problems(Schemas.open(GAME, "scene"), text).isEmpty(), text);
    }
}
