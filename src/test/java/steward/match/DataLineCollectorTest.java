package steward.match;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Map;
import org.junit.jupiter.api.Test;

/** What bots report on stderr for rating tools. */
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
}
