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
import steward.bot.TestBots;
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

/** The schemas of the games that are no pod race against real traffic; that of the pod race: {@link TrafficTest}. */
class GameSchemasTest {

    /** The schema of a frame, or else of an answer. */
    static Schema schemaOf(String game, String line) {
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
        int[] turns = new int[1];
        Bot failing = TestBots.answering(line -> {
            String answer = ++turns[0] == 5 ? fifth : turns[0] % 2 == 1 ? odd : even;
            int each = answer.indexOf("EACH");
            if (each < 0) {
                return answer;
            }
            int own = line.substring(line.indexOf("\"own\":["), line.indexOf(']')).split(",").length;
            String chip = answer.substring(each + 4, answer.indexOf(']'));
            return answer.replace("EACH" + chip, (chip + ",").repeat(own - 1) + chip);
        });
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

    /** A fault in its fifth turn is worth the score of a race that is lost. */
    @Test
    void aFaultOfASearchRaceHasItsScore() {
        Recorded match = Recorded.of(TestScenes.open("search-race"), 4,
            List.of(TestBots.answering(line -> "left!")));
        assertEquals(1000, match.result().players().get(0).score());
        assertEquals(Recorded.whole(1), match.verify());
    }
}
