package steward.replay.verify;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import steward.game.GameSetup;
import steward.match.TestScenes;
import steward.replay.Recorded;
import steward.replay.ReplayException;

/** The version of the law in the header of a replay, and what becomes of a replay of another one. */
class ReplayedLawTest {

    private static final String BEFORE = ",\"angles\"";

    /** A match on a rung, without the version of the law that it was played by. */
    private static String recorded(GameSetup setup) {
        return Recorded.of(setup, 7, 0).text().replaceFirst(",\"law\":\\d+", "");
    }

    private static GameSetup on(String rung) {
        return TestScenes.changed("mad-pod-racing", "\"arithmetic\": \"official\"",
            "\"arithmetic\": \"" + rung + "\"");
    }

    @ParameterizedTest
    @ValueSource(strings = {"official", "double", "compensated", "exact"})
    void aReplayWithoutAVersionIsOfTheFirstLaw(String rung) {
        GameSetup setup = on(rung);
        int version = setup.plan().lawVersion();
        Verification seen = Recorded.verify(recorded(setup));
        assertEquals(version == 1, seen.verified());
        if (version == 1) {
            assertNull(seen.olderLaw());
        } else {
            assertEquals("law 1 of event/" + rung + ", this version plays law " + version, seen.olderLaw());
            assertFalse(seen.agrees());
            assertEquals(0, seen.turns());
            assertTrue(Recorded.of(setup, 7, 0).verify().verified(), "with its version");
        }
    }

    @Test
    void aLaterLawIsOfANewerProgram() {
        String later = recorded(on("double")).replaceFirst(BEFORE, ",\"law\":99" + BEFORE);
        assertEquals("r.jsonl:1: law: found 99, expected at most " + on("double").plan().lawVersion()
            + " on event/double: a newer version of Steward wrote this replay",
            assertThrows(ReplayException.class, () -> Recorded.verify(later)).getMessage());
    }

    /** Two spellings of one law would give one match two hashes. */
    @ParameterizedTest
    @ValueSource(ints = {1, 0, -1})
    void theFirstLawIsNotNamed(int law) {
        String named = recorded(on("double")).replaceFirst(BEFORE, ",\"law\":" + law + BEFORE);
        assertEquals("r.jsonl:1: law: found " + law + ", expected at least 2, or none for 1",
            assertThrows(ReplayException.class, () -> Recorded.verify(named)).getMessage());
    }
}
