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
import org.junit.jupiter.params.provider.CsvSource;
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

    @ParameterizedTest
    @Tag("slow")
    @ValueSource(strings = {"mad-pod-racing", "walled-race", "duel"})
    @Tag("campaign")
    void theVeteranBeatsThePlainBotFromBothSides(String name) {
        theVeteranBeatsThePlainBot(name, 3, 5);
    }

    /** Measured over seeds 1..200, both sides: see the figure in the class doc of {@link Veteran}. */
    @Test
    @Tag("campaign")
    void theVeteranBeatsThePlainBotInManyGames() {
        SCENES.forEach(name -> theVeteranBeatsThePlainBot(name, 20, 36));
    }

    private static void theVeteranBeatsThePlainBot(String name, int seeds, int least) {
        GameSetup scene = BundledBotMatches.scene(name);
        int won = 0;
        for (long seed = 1; seed <= seeds; seed++) {
            won += BundledBotMatches.play(scene, seed, new Veteran(), new Racer()).winner() == 0 ? 1 : 0;
            won += BundledBotMatches.play(scene, seed, new Racer(), new Veteran()).winner() == 1 ? 1 : 0;
        }
        assertTrue(won >= least, "won " + won + " of " + 2 * seeds + " on " + name);
    }

    @ParameterizedTest
    @CsvSource({"1, 2", "3, 2", "8, 2", "2, 4", "8, 8"})
    @Tag("slow")
    void anyNumberOfPodsAndPlayersIsPlayed(int pods, int players) {
        PodBot[] bots = new PodBot[players];
        for (int player = 0; player < players; player++) {
            bots[player] = player % 2 == 0 ? new Veteran() : new Racer();
        }
        MatchResult result = BundledBotMatches.play(BundledBotMatches.crowd(pods, players), 5, bots);
        assertFalse(result.anyFault(), result.toString());
        assertEquals(players, result.players().size());
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
