package steward.cli.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Headings that people see. */
class HeadingTextTest {

    /** A quarter of a turn is pi / 2, 90 degrees; whole turns do not count. */
    @ParameterizedTest
    @CsvSource({"0, 0", "1.5707963267948966, 90", "-1.5707963267948966, 270", "7.853981633974483, 90",
        "-1e-12, 0", "6.283185307179586, 0", "-3.14159, 180", "0.001, 0.1"})
    void radiansBecomeDegrees(double radians, String degrees) {
        assertEquals(degrees, HeadingText.of(radians, 1));
    }

    @ParameterizedTest
    @CsvSource({"heading, heading\u00b0", "vx, vx"})
    void theUnitIsSaid(String field, String title) {
        assertEquals(title, HeadingText.title(field));
    }
}
