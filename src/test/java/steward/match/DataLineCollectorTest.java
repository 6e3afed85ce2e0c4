package steward.match;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Map;
import org.junit.jupiter.api.Test;

/** Data that bots report on stderr for rating tools. */
class DataLineCollectorTest {

    private final DataLineCollector data = new DataLineCollector(2);

    @Test
    void theLastValueCounts() {
        data.read(0, "[TDATA] map = 3\n[PDATA] depth = 5\nhello\n[PDATA] depth = 7\n");
        data.read(1, "[TDATA] map = 4\r\n[PDATA]depth=1\r\n");
        data.end();
        assertEquals(Map.of("map", "4"), data.match());
        assertEquals(Map.of("depth", "7"), data.player(0));
        assertEquals(Map.of("depth", "1"), data.player(1));
    }

    @Test
    void sumsAddUpOverTheTurns() {
        data.read(0, "[PDATA+] nodes = 100\n");
        data.read(0, null);
        data.read(0, "[PDATA+] nodes = 20\n[PDATA+] share = 0.5\n[PDATA+] nodes = 3\n[PDATA+] share = 0.25\n");
        assertEquals(Map.of("nodes", "123", "share", "0.75"), data.player(0));
    }

    @Test
    void valuesKeepTheirBlanksAndEqualsSigns() {
        data.read(0, "[PDATA] name =  a b = c \n");
        assertEquals(Map.of("name", "a b = c"), data.player(0));
    }

    @Test
    void whatIsNoAssignmentIsPassedOver() {
        data.read(0, "[PDATA] depth\n[PDATA] = 5\n[TDATA]\n [PDATA] a = 1\nx [PDATA] b = 2\n[pdata] c = 3\n");
        data.end();
        assertEquals(Map.of(), data.player(0));
        assertEquals(Map.of(), data.match());
    }

    @Test
    void whatIsNoNumberAddsNothing() {
        data.read(0, "[PDATA+] n = 4\n[PDATA+] n = many\n[PDATA+] n = NaN\n");
        assertEquals(Map.of("n", "4"), data.player(0));
    }

    @Test
    void aLineThatComesInTwoPiecesIsOneLine() {
        data.read(0, "[PDATA] depth = 1");
        data.read(1, "[PDATA] depth = 9\n");
        data.read(0, "2\n[PDATA] la");
        data.read(0, "st = ");
        data.read(0, "yes");
        assertEquals(Map.of("depth", "12"), data.player(0));
        data.end();
        assertEquals(Map.of("depth", "12", "last", "yes"), data.player(0));
    }

    /** A result is a line of a replay, which is bounded. */
    @Test
    void whatIsTooMuchInAllIsPassedOver() {
        for (int k = 0; k < 1000; k++) {
            data.read(0, "[PDATA] key" + k + " = " + "x".repeat(500) + "\n");
        }
        int size = data.player(0).entrySet().stream().mapToInt(e -> e.getKey().length() + e.getValue().length()).sum();
        assertEquals("x".repeat(500), data.player(0).get("key0"));
        assertEquals(true, size > 15_000 && size <= 1 << 14, "characters kept: " + size);
        data.read(0, "[PDATA] key0 = y\n[PDATA] last = z\n");
        assertEquals("y", data.player(0).get("key0"), "less than before always fits");
        assertEquals("z", data.player(0).get("last"));
    }
}
