package steward.schema;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.networknt.schema.Schema;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.bot.Bot;
import steward.bots.BundledBots;
import steward.bots.LineBot;
import steward.bots.fantasticbits.Captain;
import steward.bots.fantasticbits.Chaser;
import steward.bots.meanmax.Gatherer;
import steward.bots.meanmax.Marauder;
import steward.bots.pokerchiprace.Glutton;
import steward.bots.pokerchiprace.Nibbler;
import steward.bots.searchrace.Driver;
import steward.game.GameSetup;
import steward.match.TestScenes;
import steward.replay.Recorded;
import steward.scene.SceneReader;
import steward.scene.json.SceneException;

/**
 * The schemas of the games that are no pod race against real traffic, and against what the reader of scenes says. Those
 * of the pod race: {@link TrafficTest}, {@link SceneSchemaTest}.
 */
class GameSchemasTest {

    private static Schema schemaOf(String game, String line) {
        for (String type : List.of("setup", "turn", "end")) {
            if (line.contains("\"type\":\"" + type + "\"")) {
                return Schemas.open(game, type);
            }
        }
        return Schemas.open(game, "answer");
    }

    private static void checkReplay(String game, Recorded match) {
        Schema replay = Schemas.open(game, "replay");
        for (String line : match.lines()) {
            assertEquals(List.of(), Schemas.problems(replay, line), line);
        }
        assertNull(match.verify().difference());
    }

    @SafeVarargs
    private static Recorded match(GameSetup setup, List<String> lines, Supplier<? extends LineBot>... line) {
        List<Bot> bots = new ArrayList<>(List.of(BundledBots.of(line[0].get(), lines::add)));
        for (int player = 1; player < setup.create(4).players(); player++) {
            bots.add(BundledBots.of(line[player % line.length].get()));
        }
        return Recorded.of(setup, 4, bots);
    }

    /** Whole matches, and texts that stand in their replays. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
        mean-max               | 3 | "events" "wall" "skill":"oil" "wrecks":[{
        fantastic-bits         | 2 | "events" "wall" "spell":"flipendo" "throw":500 "outOfPlay":[{ "cast":{ "held":true
        fantastic-bits-contest | 2 | "events" "wall" "spell":"flipendo" "throw":500 "outOfPlay":[{ "cast":{ "held":true
        poker-chip-race        | 2 | "kind":"birth" "kind":"death" "wall" "paths"
        poker-chip-race        | 3 | "kind":"birth" "kind":"death" "wall" "paths"
        poker-chip-race        | 4 | "kind":"birth" "kind":"death" "wall" "paths"
        search-race            | 1 | "events"
        """)
    @Tag("slow")
    void everyLineOfAWholeMatchIsValid(String scene, int players, String seen) {
        GameSetup setup = scene.equals("poker-chip-race")
            ? TestScenes.changed(scene, "\"players\": 2", "\"players\": " + players) : TestScenes.open(scene);
        String game = setup.scene().gameId();
        List<String> lines = new ArrayList<>();
        Recorded match = switch (game) {
            case Schemas.MEAN_MAX -> match(setup, lines, Marauder::new, Gatherer::new);
            case Schemas.FANTASTIC_BITS -> match(setup, lines, Captain::new, Chaser::new);
            case Schemas.POKER_CHIP_RACE -> match(setup, lines, Glutton::new, Nibbler::new, Nibbler::new, Nibbler::new);
            default -> match(setup, lines, Driver::new);
        };
        if (!game.equals(Schemas.POKER_CHIP_RACE)) {
            assertEquals(2 * match.result().turns() + 2, lines.size());
        }
        for (String line : lines) {
            assertEquals(List.of(), Schemas.problems(schemaOf(game, line), line), line);
        }
        checkReplay(game, match);
        for (String each : seen.split(" ")) {
            assertTrue(match.text().contains(each), each);
        }
    }

    /** Answers of an odd turn, an even one and the fifth, which fails; EACH is repeated for each own chip. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
        mean-max \
        | {"looters":[{"x":1.5,"y":2,"skill":true},{"wait":true},{"x":1.5,"y":2,"power":0.5}],"message":"hi"} \
        | {"looters":[{"x":1.5,"y":2,"skill":true},{"wait":true},{"x":1.5,"y":2,"power":0.5}],"message":"hi"} \
        | {"looters":[]} | looters: found 0, expected 3
        fantastic-bits | {"wizards":[{"x":1.5,"y":2,"power":0.5},{"x":1.5,"y":2,"power":150}],"message":"hi"} \
        | {"wizards":[{"x":1.5,"y":2,"power":0.5},{"x":1.5,"y":2,"power":150}],"message":"hi"} \
        | {"wizards":[{"x":1.5,"y":2,"power":0.5},{"x":1.5,"y":2,"throw":1}],"message":"hi"} \
        | wizards[1]: found a throw without a snaffle
        poker-chip-race | {"chips":[EACH{"x":1.5,"y":-2.25}],"message":"hi"} \
        | {"chips":[EACH{"wait":true}],"message":"hi"} | {"chips":[]} | chips: found 0, expected
        search-race | {"x":1.5,"y":2,"thrust":7,"message":"debug"} | {"x":1.5,"y":2,"thrust":7,"message":"debug"} \
        | left! | not JSON
        """)
    @Tag("slow")
    void aMatchWithAFaultIsValid(String game, String odd, String even, String fifth, String problem) {
        GameSetup setup = game.equals(Schemas.POKER_CHIP_RACE)
            ? TestScenes.changed(game, "\"players\": 2", "\"players\": 3") : TestScenes.open(game);
        Bot failing = new Bot() {

            private int turn;

            @Override
            public void setup(String line) {
                turn = 0;
            }

            @Override
            public String turn(String line) {
                String answer = ++turn == 5 ? fifth : turn % 2 == 1 ? odd : even;
                int each = answer.indexOf("EACH");
                if (each < 0) {
                    return answer;
                }
                int own = line.substring(line.indexOf("\"own\":["), line.indexOf(']')).split(",").length;
                String chip = answer.substring(each + 4, answer.indexOf(']'));
                return answer.replace("EACH" + chip, (chip + ",").repeat(own - 1) + chip);
            }
        };
        List<Bot> bots = new ArrayList<>(List.of(failing));
        while (bots.size() < setup.create(4).players()) {
            bots.add(BundledBots.of(switch (game) {
                case Schemas.MEAN_MAX -> new Gatherer();
                case Schemas.FANTASTIC_BITS -> new Chaser();
                default -> new Nibbler();
            }));
        }
        Recorded match = Recorded.of(setup, 4, bots);
        assertEquals(bots.size() > 2, match.result().turns() > 5, match.result()::toString);
        assertTrue(match.text().contains(problem), match.text());
        checkReplay(game, match);
    }

    /** Each row: a part of the shipped scene, what stands there instead, and the verdict of both. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
        mean-max | "winningScore": 50 | "winningScore": 1 | true
        mean-max | "winningScore": 50 | "winningScore": 0 | false
        mean-max | "winningScore": 50 | "winningScore": 1001 | false
        mean-max | "maximumTurns": 200 | "maximumTurns": 10001 | false
        mean-max | "players": 3 | "players": 2 | false
        mean-max | "harvest" | "motion": {}, "harvest" | false
        mean-max | "harvest" | "race": {}, "harvest" | false
        mean-max | "harvest" | "harvst" | false
        mean-max | "radius": 6000 | "radius": 6001 | false
        mean-max | "x": 0, | "x": 1, | false
        mean-max | "type": "arena" | "type": "ring" | false
        mean-max | "pushOut": 1e-5 | "pushOut": 2e-5 | false
        mean-max | "minimumImpulse": 30 | "minimumImpulse": 31 | false
        mean-max | "pushOut": 1e-5 | "pushOut": 1e-5, "maximumImpactsPerTurn": 9 | true
        mean-max | "x": -6000 | "x": "left" | false
        mean-max | "arithmetic": "official" | "arithmetic": "exact" | true
        fantastic-bits | "variant": "puzzle" | "variant": "contest" | true
        fantastic-bits | "variant": "puzzle" | "variant": "league" | false
        fantastic-bits | "maximumTurns": 200 | "maximumTurns": 10001 | false
        fantastic-bits | "maximumTurns": 200 | "maximumTurns": 1 | true
        fantastic-bits | "players": 2 | "players": 3 | false
        fantastic-bits | "match" | "motion": {}, "match" | false
        fantastic-bits | "match" | "race": {}, "match" | false
        fantastic-bits | "match" | "mach" | false
        fantastic-bits | "width": 16000 | "width": 8000 | true
        fantastic-bits | "x": 16150 | "x": 16000 | false
        fantastic-bits | "y": 1750 | "y": 1751 | false
        fantastic-bits | "radius": 300 | "radius": 300, "restitution": 0.5 | false
        fantastic-bits | "pushOut": 1e-5 | "pushOut": 2e-5 | false
        fantastic-bits | "batchWindow": 1e-5, |  | false
        fantastic-bits | "minimumImpulse": 100 | "minimumImpulse": 101 | false
        fantastic-bits | "minimumImpulse": 100 | "minimumImpulse": 100, "deadZone": 1 | false
        fantastic-bits | "minimumImpulse": 100 | "minimumImpulse": 100, "restSpeed": 1 | false
        fantastic-bits | "pushOut": 1e-5 | "pushOut": 1e-5, "maximumImpactsPerTurn": 9 | true
        fantastic-bits | "arithmetic": "official" | "arithmetic": "exact" | true
        poker-chip-race | "maximumTurns": 300 | "maximumTurns": 1 | true
        poker-chip-race | "maximumTurns": 300 | "maximumTurns": 0 | false
        poker-chip-race | "maximumTurns": 300 | "maximumTurns": 1001 | false
        poker-chip-race | "maximumTurns": 300 | "neutral": 0, "perPlayer": 20, "radius": 1.5, "maximumTurns": 9 | true
        poker-chip-race | "maximumTurns": 300 | "symmetric": true, "maximumTurns": 9 | true
        poker-chip-race | "maximumTurns": 300 | "maximumTurns": 9, "neutral": 201 | false
        poker-chip-race | "maximumTurns": 300 | "maximumTurns": 9, "perPlayer": 0 | false
        poker-chip-race | "maximumTurns": 300 | "maximumTurns": 9, "radius": 0.5 | false
        poker-chip-race | "maximumTurns": 300 | "maximumTurns": 9, "symmetric": 1 | false
        poker-chip-race | "maximumTurns": 300 | "neutral": 3 | false
        poker-chip-race | "players": 2 | "players": 4 | true
        poker-chip-race | "players": 2 | "players": 5 | false
        poker-chip-race | "players": 2 | "players": 1 | false
        poker-chip-race | "chips" | "motion": {}, "chips" | false
        poker-chip-race | "chips" | "harvest": {}, "chips" | false
        poker-chip-race | "chips" | "chps" | false
        poker-chip-race | "x": -400 | "x": 0 | false
        poker-chip-race | "height": 515 | "height": 516 | false
        poker-chip-race | "walls": "box" | "walls": [] | false
        poker-chip-race | "chips" | "impacts": {"maximumImpactsPerTurn": 9}, "chips" | true
        poker-chip-race | "chips" | "impacts": {"pushOut": 1e-5}, "chips" | false
        poker-chip-race | "chips" | "impacts": {"minimumImpulse": 3}, "chips" | false
        poker-chip-race | "chips" | "impacts": {"restSpeed": 1}, "chips" | false
        poker-chip-race | "arithmetic": "official" | "arithmetic": "exact" | true
        poker-chip-race | "official" } | "exact" }, "impacts": {"restSpeed": 1} | true
        search-race | "by seed" | "by seed" | true
        search-race | "by seed" | 7 | true
        search-race | "by seed" | 704 | true
        search-race | "by seed" | 703 | false
        search-race | "by seed" | "random" | false
        search-race | "official": "by seed" | "points": [{"x":1,"y":2},{"x":3,"y":4}] | true
        search-race | "official": "by seed" | "points": [{"x":1,"y":2},{"x":3,"y":4.5}] | false
        search-race | "official": "by seed" | "points": [{"x":1,"y":2}] | false
        search-race | "official": "by seed" | "official": 7, "points": [{"x":1,"y":2},{"x":3,"y":4}] | false
        search-race | "official": "by seed" | "maps": 7 | false
        search-race | "players": 1 | "players": 2 | false
        search-race | "maximumTurns": 600 | "maximumTurns": 1001 | false
        search-race | "laps": 3 | "laps": 0 | false
        search-race | "map" | "impacts": {}, "map" | false
        search-race | "map" | "pods": {}, "map" | false
        search-race | "velocity": "truncate-snap" | "velocity": "truncate" | true
        search-race | "arithmetic": "official" | "arithmetic": "double" | true
        """)
    void readerAndSchemaAgree(String game, String part, String instead, boolean valid) {
        String scene = TestScenes.text(game);
        assertTrue(scene.contains(part), part);
        String text = scene.replace(part, instead == null ? "" : instead);
        String refusal = null;
        try {
            TestScenes.TYPES.open(SceneReader.read(text, "s.json"));
        } catch (SceneException problem) {
            refusal = problem.getMessage();
        }
        assertEquals(valid, refusal == null, refusal);
        assertEquals(valid, Schemas.problems(Schemas.open(game, "scene"), text).isEmpty(), text);
    }

    /** A fault in its fifth turn is worth the score of a race that is lost. */
    @Test
    void aFaultOfASearchRaceHasItsScore() {
        Recorded match = Recorded.of(TestScenes.open("search-race"), 4, List.of(new Bot() {
            @Override
            public void setup(String line) { }

            @Override
            public String turn(String line) {
                return "left!";
            }
        }));
        assertEquals(1000, match.result().players().get(0).score());
        assertEquals(Recorded.whole(1), match.verify());
    }
}
