package steward.game;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Map;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.game.meanmax.protocol.MeanMaxType.MeanMaxSetup;
import steward.match.TestScenes;
import steward.scene.SceneKey;

/** The leagues of the site as changes of a scene: fields of one block, none where the league has all rules. */
class InLeagueTest {

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "mean-max | 1 | \"maximumTurns\":200,\"version\":0}",
        "mean-max | 3 | \"maximumTurns\":200,\"version\":2}",
        "mean-max | 4 | \"harvest\":{\"winningScore\":50,\"maximumTurns\":200}",
        "mean-max | 9 | \"harvest\":{\"winningScore\":50,\"maximumTurns\":200}",
        "fantastic-bits | 1 | \"maximumTurns\":200,\"bludgers\":false,\"spells\":false}",
        "fantastic-bits | 2 | \"maximumTurns\":200,\"bludgers\":true,\"spells\":false}",
        "fantastic-bits-contest | 3 | \"match\":{\"variant\":\"contest\",\"maximumTurns\":200}"})
    void aLeagueIsWordsInTheScene(String scene, int league, String words) {
        GameSetup setup = TestScenes.open(scene);
        String json = TestScenes.TYPES.inLeague(setup, league).scene().json();
        assertTrue(json.contains(words), json);
        assertEquals(setup.scene().json(), json.replaceAll(",\"(version|bludgers|spells)\":[a-z0-9]+", ""));
    }

    /** The key of a scene follows from its fields, so that leagues go on which name none of the new ones. */
    @ParameterizedTest
    @CsvSource({"mean-max, 4", "fantastic-bits, 3", "fantastic-bits-contest, 3", "mad-pod-racing, 1", "duel, 2",
        "poker-chip-race, 1", "search-race, 1"})
    void theHighestLeagueIsTheSceneItself(String scene, int league) {
        GameSetup setup = TestScenes.open(scene);
        assertSame(setup, TestScenes.TYPES.inLeague(setup, league));
    }

    @Test
    void everyLeagueHasAKeyOfItsOwn() {
        for (Map.Entry<String, Integer> each : Map.of("mean-max", 4, "fantastic-bits", 3).entrySet()) {
            GameSetup setup = TestScenes.open(each.getKey());
            long keys = IntStream.rangeClosed(1, each.getValue())
                .mapToObj(league -> SceneKey.of(TestScenes.TYPES.inLeague(setup, league).scene())).distinct().count();
            assertEquals(each.getValue().longValue(), keys);
        }
    }

    @Test
    void aSceneOfALowerLeagueIsRaisedToo() {
        GameSetup low = TestScenes.TYPES.inLeague(TestScenes.open("mean-max"), 1);
        assertEquals(0, ((MeanMaxSetup) low).settings().version());
        assertEquals(3, ((MeanMaxSetup) TestScenes.TYPES.inLeague(low, 4)).settings().version());
    }
}
