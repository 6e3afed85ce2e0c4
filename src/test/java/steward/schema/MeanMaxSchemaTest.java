package steward.schema;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.networknt.schema.Schema;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.bot.Bot;
import steward.bots.BundledBots;
import steward.bots.meanmax.Gatherer;
import steward.bots.meanmax.Marauder;
import steward.match.TestScenes;
import steward.replay.Recorded;
import steward.scene.SceneReader;
import steward.scene.json.SceneException;

/** The schemas of Mean Max against real traffic, and against what the reader of scenes says. */
class MeanMaxSchemaTest {

    private static final String GAME = Schemas.MEAN_MAX;

    private static Schema schemaOf(String line) {
        for (String type : List.of("setup", "turn", "end")) {
            if (line.contains("\"type\":\"" + type + "\"")) {
                return Schemas.open(GAME, type);
            }
        }
        return Schemas.open(GAME, "answer");
    }

    private static void checkReplay(Recorded match) {
        Schema replay = Schemas.open(GAME, "replay");
        for (String line : match.lines()) {
            assertEquals(List.of(), Schemas.problems(replay, line), line);
        }
        assertNull(match.verify().difference());
    }

    @Test
    @Tag("slow")
    void everyLineOfAWholeMatchIsValid() {
        List<String> lines = new ArrayList<>();
        Recorded match = Recorded.of(TestScenes.open("mean-max"), 4,
            List.of(BundledBots.of(new Marauder(), lines::add), BundledBots.of(new Gatherer()),
                BundledBots.of(new Marauder())));
        assertEquals(2 * match.result().turns() + 2, lines.size());
        for (String line : lines) {
            assertEquals(List.of(), Schemas.problems(schemaOf(line), line), line);
        }
        checkReplay(match);
        for (String seen : List.of("\"events\"", "\"wall\"", "\"skill\":\"oil\"", "\"wrecks\":[{")) {
            assertTrue(match.text().contains(seen), seen);
        }
    }

    /** It waits, casts at decimal places, and fails in turn 5; the others go on. */
    @Test
    @Tag("slow")
    void aMatchWithAFaultIsValid() {
        Recorded match = Recorded.of(TestScenes.open("mean-max"), 4, List.of(new Bot() {

            private int turn;

            @Override
            public void setup(String line) {
                turn = 0;
            }

            @Override
            public String turn(String line) {
                return ++turn == 5 ? "{\"looters\":[]}" : "{\"looters\":[{\"x\":1.5,\"y\":2,\"skill\":true},"
                    + "{\"wait\":true},{\"x\":1.5,\"y\":2,\"power\":0.5}],\"message\":\"hi\"}";
            }
        }, BundledBots.of(new Gatherer()), BundledBots.of(new Gatherer())));
        assertTrue(match.result().turns() > 5, match.result().toString());
        assertTrue(match.text().contains("looters: found 0, expected 3"));
        checkReplay(match);
    }

    /** Each row: a part of the shipped scene, what stands there instead, and the verdict of both. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
        "winningScore": 50  | "winningScore": 1            | true
        "winningScore": 50  | "winningScore": 0            | false
        "winningScore": 50  | "winningScore": 1001         | false
        "maximumTurns": 200 | "maximumTurns": 10001        | false
        "players": 3        | "players": 2                 | false
        "harvest"           | "motion": {}, "harvest"      | false
        "harvest"           | "race": {}, "harvest"        | false
        "harvest"           | "harvst"                     | false
        "radius": 6000      | "radius": 6001               | false
        "x": 0,             | "x": 1,                      | false
        "type": "arena"     | "type": "ring"               | false
        "pushOut": 1e-5     | "pushOut": 2e-5              | false
        "minimumImpulse": 30| "minimumImpulse": 31         | false
        "pushOut": 1e-5     | "pushOut": 1e-5, "maximumImpactsPerTurn": 9 | true
        "x": -6000          | "x": "left"                  | false
        "arithmetic": "official" | "arithmetic": "exact"   | true
        """)
    void readerAndSchemaAgree(String part, String instead, boolean valid) {
        String scene = TestScenes.text("mean-max");
        String text = scene.replace(part, instead);
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
