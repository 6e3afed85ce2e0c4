package steward.game;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.OptionalLong;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The site's seeds have up to 64 bits, and stand among other lines. */
class ShownSeedTest {

    @ParameterizedTest
    @ValueSource(longs = {0, 7, -12, 8351477129486336000L, Long.MIN_VALUE, Long.MAX_VALUE})
    void theSeedIsReadFromItsLine(long seed) {
        for (String input : new String[] {"seed=" + seed, "map=1 2\r\nseed=" + seed + "\r\nboss=x\r\n"}) {
            assertEquals(OptionalLong.of(seed), ShownSeed.of(input));
            assertEquals(seed, ShownSeed.required(input, "g.json"));
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "seed", "seed=", "seed=1.5", "seed=x", "sneed=1", "seed=1 2",
        "seed=9223372036854775808", "seed=99999999999999999999"})
    void everythingElseIsNone(String input) {
        assertEquals(OptionalLong.empty(), ShownSeed.of(input));
    }

    @Test
    void whereOneIsNeededTheErrorShowsWhatStandsThere() {
        assertEquals("g.json: refereeInput: found \"seed=x\", expected a line seed=NUMBER",
            assertThrows(IllegalArgumentException.class, () -> ShownSeed.required("seed=x", "g.json")).getMessage());
    }
}
