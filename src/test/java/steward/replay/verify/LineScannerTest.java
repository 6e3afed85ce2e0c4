package steward.replay.verify;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.charset.StandardCharsets;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Times are numbers of up to 18 digits, as a long holds them, without leading zeros, or null. */
class LineScannerTest {

    @ParameterizedTest
    @CsvSource(delimiter = ';', value = {"0; true", "1,22; true", "null,5; true", "5,null; true",
        "123456789012345678; true", "1234567890123456789; false", "00; false", "01; false", "''; false", "1,; false",
        "-1; false", "1.5; false", "nul; false", ",1; false"})
    void timesAreWholeNumbersOrNull(String times, boolean expected) {
        byte[] line = (",\"times\":{\"answerNanos\":[" + times + "]}}").getBytes(StandardCharsets.UTF_8);
        assertEquals(expected, LineScanner.isTimes(line, 0));
        byte[] cut = (",\"times\":{\"answerNanos\":[" + times).getBytes(StandardCharsets.UTF_8);
        assertEquals(false, LineScanner.isTimes(cut, 0));
    }
}
