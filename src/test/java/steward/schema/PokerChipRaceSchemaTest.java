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
import steward.bots.pokerchiprace.Glutton;
import steward.bots.pokerchiprace.Nibbler;
import steward.match.TestScenes;
import steward.replay.Recorded;
import steward.scene.SceneReader;
import steward.scene.json.SceneException;

/** The schemas of the Poker Chip Race against real traffic, and against what the reader of scenes says. */
class PokerChipRaceSchemaTest {

    private static final String GAME = Schemas.POKER_CHIP_RACE;

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
    @CsvSource({"2", "3", "4"})
    @Tag("slow")
    void everyLineOfAWholeMatchIsValid(int players) {
        List<String> lines = new ArrayList<>();
        List<Bot> bots = new ArrayList<>(List.of(BundledBots.of(new Glutton(), lines::add)));
        for (int player = 1; player < players; player++) {
            bots.add(BundledBots.of(new Nibbler()));
        }
        Recorded match = Recorded.of(
            TestScenes.changed("poker-chip-race", "\"players\": 2", "\"players\": " + players), 4, bots);
        for (String line : lines) {
            assertEquals(List.of(), Schemas.problems(schemaOf(line), line), line);
        }
        checkReplay(match);
        for (String seen : List.of("\"kind\":\"birth\"", "\"kind\":\"death\"", "\"wall\"", "\"paths\"")) {
            assertTrue(match.text().contains(seen), seen);
        }
    }

    /** It pushes to decimal places, waits, and fails in turn 5; the two others go on. */
    @Test
    void aMatchWithAFaultIsValid() {
        Recorded match = Recorded.of(TestScenes.changed("poker-chip-race", "\"players\": 2", "\"players\": 3"), 4,
            List.of(new Bot() {

                private int turn;

                @Override
                public void setup(String line) {
                    turn = 0;
                }

                @Override
                public String turn(String line) {
                    int own = line.substring(line.indexOf("\"own\":["), line.indexOf(']')).split(",").length;
                    String each = turn % 2 == 0 ? ",{\"x\":1.5,\"y\":-2.25}" : ",{\"wait\":true}";
                    return ++turn == 5 ? "{\"chips\":[]}"
                        : "{\"chips\":[" + each.repeat(own).substring(1) + "],\"message\":\"hi\"}";
                }
            }, BundledBots.of(new Nibbler()), BundledBots.of(new Nibbler())));
        assertTrue(match.result().turns() > 5, match.result().toString());
        assertTrue(match.text().contains("chips: found 0, expected "));
        checkReplay(match);
    }

    /** Each row: a part of the shipped scene, what stands there instead, and the verdict of both. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
        "maximumTurns": 300 | "maximumTurns": 1            | true
        "maximumTurns": 300 | "maximumTurns": 0            | false
        "maximumTurns": 300 | "maximumTurns": 1001         | false
        "maximumTurns": 300 | "maximumTurns": 9, "neutral": 0, "perPlayer": 20, "radius": 1.5, "symmetric": true | true
        "maximumTurns": 300 | "maximumTurns": 9, "neutral": 201 | false
        "maximumTurns": 300 | "maximumTurns": 9, "perPlayer": 0 | false
        "maximumTurns": 300 | "maximumTurns": 9, "radius": 0.5 | false
        "maximumTurns": 300 | "maximumTurns": 9, "symmetric": 1 | false
        "maximumTurns": 300 | "neutral": 3                 | false
        "players": 2        | "players": 4                 | true
        "players": 2        | "players": 5                 | false
        "players": 2        | "players": 1                 | false
        "chips"             | "motion": {}, "chips"        | false
        "chips"             | "harvest": {}, "chips"       | false
        "chips"             | "chps"                       | false
        "x": -400           | "x": 0                       | false
        "height": 515       | "height": 516                | false
        "walls": "box"      | "walls": []                  | false
        "chips"             | "impacts": {"maximumImpactsPerTurn": 9}, "chips" | true
        "chips"             | "impacts": {"pushOut": 1e-5}, "chips" | false
        "chips"             | "impacts": {"minimumImpulse": 3}, "chips" | false
        "chips"             | "impacts": {"restSpeed": 1}, "chips" | false
        "arithmetic": "official" | "arithmetic": "exact"   | true
        "official" }        | "exact" }, "impacts": {"restSpeed": 1} | true
        """)
    void readerAndSchemaAgree(String part, String instead, boolean valid) {
        String scene = TestScenes.text("poker-chip-race");
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
