package steward.game.searchrace.protocol;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.BufferedReader;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.io.StringReader;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests of simulators, as lines. */
class SearchRaceSimulationTest {

    private static final String COURSE = "3\n0 0\n5000 0\n10000 0\n";

    private static String simulate(String input) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        SearchRaces.changed().simulate(new BufferedReader(new StringReader(input)), new PrintStream(out));
        return out.toString(StandardCharsets.UTF_8).replace("\r", "");
    }

    /** 200 to the right of which 170 are kept; the edge at 4400 after half a turn; 18 degrees at most. */
    @Test
    void testsAreAnsweredByTheNewStates() throws IOException {
        assertEquals("200 0 170 0 0 0 2.0\n4500 0 170 0 0 1 0.5\n", simulate(COURSE
            + "2\n0 0 0 0 0 0\nEXPERT 0 200\n\n4300 0 200 0 0 0\n9000 0 0\n"));
        assertEquals("100 7 0 0 18 4 2.0\n", simulate(COURSE + "0\n" + COURSE + "1\n100 7 0 0 0 4\n100 500 0\n"));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "1 2 3 4 5 9;1 2 3 | 6 | found passed \"9\", expected a whole number 0..8",
        "1 2 3 4 5;1 2 3 | 6 | found \"1 2 3 4 5\", expected x y vx vy angleDegrees passed",
        "1 2 3 4 x 0;1 2 3 | 6 | found angleDegrees \"x\", expected a number -1e9..1e9",
        "1 2 3 4 5 0;1 2 201 | 7 | THRUST: found \"201\", expected a whole number 0..200",
        "1 2 3 4 5 0 | 7 | found the end of the input, expected command: X Y THRUST or EXPERT ANGLE THRUST"})
    void aWrongLineIsNamed(String lines, int line, String problem) {
        assertEquals("input line " + line + ": " + problem, assertThrows(IllegalArgumentException.class,
            () -> simulate(COURSE + "1\n" + lines.replace(';', '\n') + "\n")).getMessage());
    }
}
