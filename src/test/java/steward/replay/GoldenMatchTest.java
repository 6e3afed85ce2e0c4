package steward.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Scene, seed and bots determine the match on every machine, JDK and JIT level. The numbers are what this test found
 * when it was first run; nothing outside confirms them. When one changes, old replays of that scene no longer verify:
 * that is right only if its rules, its file or the bot drawn by lot were changed on purpose.
 */
class GoldenMatchTest {

    @ParameterizedTest
    @CsvSource({
        "mad-pod-racing, 1, 170, f12ad064a4fcb718",
        "walled-race,    1, 229, ef6535bfdc81a67a",
        "duel,           1, 45, 0397bee626a24c41"})
    void theLastTurnHasThisHash(String scene, long seed, int turns, String hash) {
        Recorded match = Recorded.of(scene, seed);
        String last = match.lines().get(match.result().turns());

        assertEquals(turns + " " + hash, match.result().turns() + " "
            + last.replaceFirst(".*\"hash\":\"([0-9a-f]{16})\".*", "$1"));
    }
}
