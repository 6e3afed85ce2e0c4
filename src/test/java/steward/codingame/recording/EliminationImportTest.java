package steward.codingame.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.bot.Bot;
import steward.bot.TestBots;
import steward.game.GameSetup;
import steward.game.podrace.RulesEdition;
import steward.match.TestScenes;
import steward.replay.verify.Verification;

/**
 * Games in which nobody passes a checkpoint, in the form of the site's JSON. By live rules one more turn is played
 * after the 100th, which shows 0 turns left; by those of the contest it is the last.
 */
class EliminationImportTest {

    /** Pods that stay where they are. */
    private static Bot idle() {
        return TestBots.answering(line -> "{\"pods\":[{\"x\":0,\"y\":0,\"thrust\":0},{\"x\":0,\"y\":0,\"thrust\":0}]}");
    }

    private static OfficialGame game(RulesEdition rules) {
        GameSetup setup = rules == RulesEdition.LIVE ? TestScenes.open("mad-pod-racing")
            : TestScenes.contest("mad-pod-racing");
        return OfficialGame.play(setup, 3, idle(), idle());
    }

    private static Verification verified(OfficialGame game, RulesEdition rules) {
        return ImportedRecording.of(game.json(), rules).verified();
    }

    @ParameterizedTest
    @CsvSource({"LIVE, 101", "CONTEST, 100"})
    void aGameOfEitherEditionVerifiesByItsOwnRules(RulesEdition rules, int turns) {
        OfficialGame game = game(rules);
        assertEquals(turns, game.turns());
        Verification found = verified(game, rules);
        assertNull(found.difference());
        assertTrue(found.verified());
        assertEquals(turns, found.turns());
    }

    @Test
    void byOtherRulesItDoesNot() {
        for (RulesEdition rules : RulesEdition.values()) {
            RulesEdition other = rules == RulesEdition.LIVE ? RulesEdition.CONTEST : RulesEdition.LIVE;
            assertNotNull(verified(game(rules), other).difference(), rules.word());
        }
    }

    @Test
    void rulesAreThoseOfTheLiveServerUnlessNamed() {
        assertTrue(verified(game(RulesEdition.LIVE), null).verified());
    }

    @Test
    void onlyAPodRaceHasEditions() {
        String lines = "{\"stdin\":" + List.of() + ",\"stdout\":[]}";
        assertThrows(IllegalArgumentException.class,
            () -> RecordingImport.of(lines, "game.json", TestScenes.TYPES, RulesEdition.CONTEST));
        String game = ServerMeanMax.play(5, 3).json();
        assertEquals("game.json: found another game, expected a pod race where rules are named",
            assertThrows(IllegalArgumentException.class, () -> RecordingImport.of(game, "game.json", TestScenes.TYPES,
                RulesEdition.CONTEST)).getMessage());
    }
}
