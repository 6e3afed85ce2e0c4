package steward.guest;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests of games for one, and the value that orders results. */
class SoloTestsTest {

    private static final SoloTests TESTS = new SoloTests(List.of(List.of("1"), List.of("2"), List.of("3")), "points",
        false);

    @ParameterizedTest
    @CsvSource({"1, 1", "3, 3", "4, 1", "0, 3", "-1, 2", "9223372036854775807, 1"})
    void seedsRunThroughTheTests(long seed, String test) {
        assertEquals(List.of(test), TESTS.lines(seed));
        assertEquals(List.of("seed=" + seed), SoloTests.NONE.lines(seed));
    }

    /** Each row: the block METADATA, and the score where SCORES says 1. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', nullValues = "none", textBlock = """
        {"points":"53430.0"}       | 53430
        {"points":27400}           | 27400
        {"points":"-2.5"}          | -2.5
        {"points":"many"}          | 1
        {"points":"NaN"}           | 1
        {"other":"5"}              | 1
        no JSON                    | 1
        none                       | 1
        """)
    void theCriterionIsTheScore(String metadata, double score) {
        assertEquals(score, TESTS.score(metadata, 1));
    }

    /** A game without a value is worse than any with one, also if less is better; a score still orders such games. */
    @Test
    void aMissingValueIsNeverTheBetterOne() {
        SoloTests lower = new SoloTests(List.of(), "time", true);
        assertEquals(12, lower.score("{\"time\":12}", 1));
        assertEquals(1e12 - 1, lower.score("{}", 1));
        assertEquals(1e12 + 1, lower.score("{}", -1));
        assertEquals(1, new SoloTests(List.of(), "", true).score("{\"time\":12}", 1));
    }

    /** Referees state the criterion of a test that was failed, too. */
    @Test
    void aFailedTestHasNoValue() {
        assertEquals(1e12, new SoloTests(List.of(), "time", true).score("{\"time\":3}", 0));
        assertEquals(0, TESTS.score("{\"points\":30000}", 0));
        assertEquals(-1, TESTS.score("{\"points\":30000}", -1));
    }
}
