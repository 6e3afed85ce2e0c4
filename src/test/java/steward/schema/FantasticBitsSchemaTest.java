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
import org.junit.jupiter.params.provider.ValueSource;
import steward.bot.Bot;
import steward.bots.BundledBots;
import steward.bots.fantasticbits.Captain;
import steward.bots.fantasticbits.Chaser;
import steward.match.TestScenes;
import steward.replay.Recorded;
import steward.scene.SceneReader;
import steward.scene.json.SceneException;

/** The schemas of Fantastic Bits against real traffic, and against what the reader of scenes says. */
class FantasticBitsSchemaTest {

    private static final String GAME = Schemas.FANTASTIC_BITS;

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

    @ParameterizedTest
    @ValueSource(strings = {"fantastic-bits", "fantastic-bits-contest"})
    @Tag("slow")
    void everyLineOfAWholeMatchIsValid(String scene) {
        List<String> lines = new ArrayList<>();
        Recorded match = Recorded.of(TestScenes.open(scene), 4,
            List.of(BundledBots.of(new Captain(), lines::add), BundledBots.of(new Chaser())));
        assertEquals(2 * match.result().turns() + 2, lines.size());
        for (String line : lines) {
            assertEquals(List.of(), Schemas.problems(schemaOf(line), line), line);
        }
        checkReplay(match);
        for (String seen : List.of("\"events\"", "\"wall\"", "\"spell\":\"flipendo\"", "\"throw\":500",
            "\"outOfPlay\":[{", "\"cast\":{", "\"held\":true")) {
            assertTrue(match.text().contains(seen), seen);
        }
    }

    /** It moves to decimal places, and its second wizard's command fails in turn 5: the first still moves. */
    @Test
    void aMatchWithAFaultIsValid() {
        Recorded match = Recorded.of(TestScenes.open("fantastic-bits"), 4, List.of(new Bot() {

            private int turn;

            @Override
            public void setup(String line) {
                turn = 0;
            }

            @Override
            public String turn(String line) {
                return "{\"wizards\":[{\"x\":1.5,\"y\":2,\"power\":0.5},{\"x\":1.5,\"y\":2,"
                    + (++turn == 5 ? "\"throw\":1" : "\"power\":150") + "}],\"message\":\"hi\"}";
            }
        }, BundledBots.of(new Chaser())));
        assertEquals(5, match.result().turns(), match.result().toString());
        assertTrue(match.text().contains("wizards[1]: found a throw without a snaffle"), match.text());
        checkReplay(match);
    }

    /** Each row: a part of the shipped scene, what stands there instead, and the verdict of both. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
        "variant": "puzzle"  | "variant": "contest"         | true
        "variant": "puzzle"  | "variant": "league"          | false
        "maximumTurns": 200  | "maximumTurns": 10001        | false
        "maximumTurns": 200  | "maximumTurns": 1            | true
        "players": 2         | "players": 3                 | false
        "match"              | "motion": {}, "match"        | false
        "match"              | "race": {}, "match"          | false
        "match"              | "mach"                       | false
        "width": 16000       | "width": 8000                | true
        "x": 16150           | "x": 16000                   | false
        "y": 1750            | "y": 1751                    | false
        "radius": 300        | "radius": 300, "restitution": 0.5 | false
        "pushOut": 1e-5      | "pushOut": 2e-5              | false
        "batchWindow": 1e-5, |                              | false
        "minimumImpulse": 100| "minimumImpulse": 101        | false
        "minimumImpulse": 100| "minimumImpulse": 100, "deadZone": 1 | false
        "minimumImpulse": 100| "minimumImpulse": 100, "restSpeed": 1 | false
        "pushOut": 1e-5      | "pushOut": 1e-5, "maximumImpactsPerTurn": 9 | true
        "arithmetic": "official" | "arithmetic": "exact"    | true
        """)
    void readerAndSchemaAgree(String part, String instead, boolean valid) {
        String scene = TestScenes.text("fantastic-bits");
        String text = scene.replace(part, instead == null ? "" : instead);
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
