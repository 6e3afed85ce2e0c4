package steward.bots;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import steward.game.Game;
import steward.game.GameJson;
import steward.game.GameSetup;
import steward.match.MatchListener;
import steward.match.MatchResult;
import steward.match.TestSize;
import steward.match.Turn;

/** The bundled bots over whole matches: no fault, a finish, and the veteran in front. */
@Execution(ExecutionMode.CONCURRENT)
class BotsInMatchesTest {

    private static final List<String> SCENES = List.of("mad-pod-racing", "walled-race", "duel");

    @ParameterizedTest
    @ValueSource(strings = {"mad-pod-racing", "walled-race", "duel"})
    @Tag("sized")
    void plainBotsFinishEveryRaceWithoutAFault(String name) {
        GameSetup scene = BundledBotMatches.scene(name);
        for (long seed = 1; seed <= TestSize.of(6, 30); seed++) {
            MatchResult result = BundledBotMatches.play(scene, seed, new Racer(), new Racer());
            assertFalse(result.anyFault(), result.toString());
            assertTrue(result.ending().startsWith("finished"), result.toString());
        }
    }

    @ParameterizedTest
    @Tag("slow")
    @ValueSource(strings = {"mad-pod-racing", "walled-race", "duel"})
    void veteransPlayEachOtherWithoutAFault(String name) {
        veteransPlayEachOther(name, 2);
    }

    @Test
    @Tag("campaign")
    void veteransPlayEachOtherTenTimesWithoutAFault() {
        SCENES.forEach(name -> veteransPlayEachOther(name, 10));
    }

    private static void veteransPlayEachOther(String name, int seeds) {
        GameSetup scene = BundledBotMatches.scene(name);
        for (long seed = 1; seed <= seeds; seed++) {
            MatchResult result = BundledBotMatches.play(scene, seed, new Veteran(), new Veteran());
            assertFalse(result.anyFault(), result.toString());
        }
    }

    /** Figures stand in the class doc of {@link Veteran}. Equal bots would win 27 of 40 once in 50 times. */
    @Test
    @Tag("campaign")
    void theVeteranBeatsThePlainBotInManyGames() {
        for (String name : SCENES) {
            GameSetup scene = BundledBotMatches.scene(name);
            int won = 0;
            for (long seed = 1; seed <= 20; seed++) {
                won += BundledBotMatches.play(scene, seed, new Veteran(), new Racer()).winner() == 0 ? 1 : 0;
                won += BundledBotMatches.play(scene, seed, new Racer(), new Veteran()).winner() == 1 ? 1 : 0;
            }
            assertTrue(won >= 27, "won " + won + " of 40 on " + name);
        }
    }

    @Test
    void aMatchPlayedTwiceIsTheSameInEveryTurn() {
        GameSetup scene = BundledBotMatches.scene("mad-pod-racing");
        Hashes once = new Hashes();
        Hashes again = new Hashes();
        MatchResult result = BundledBotMatches.play(scene, 77, once, new Veteran(), new Racer());
        BundledBotMatches.play(scene, 77, again, new Veteran(), new Racer());
        assertEquals(result.turns(), once.values.size());
        assertEquals(once.values, again.values);
    }

    /** The state after every turn. */
    private static final class Hashes implements MatchListener {

        private final List<Long> values = new ArrayList<>();
        private Game game;

        @Override
        public void start(Game started, GameJson codec) {
            game = started;
        }

        @Override
        public void played(Turn turn) {
            values.add(game.hash());
        }
    }
}
