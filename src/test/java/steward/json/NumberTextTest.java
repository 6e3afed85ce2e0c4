package steward.json;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.match.TestSize;
import steward.numerics.SplitMix64;
import steward.replay.Recorded;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.ObjectWriteContext;

/**
 * The text of a number in a replay must not depend on the JDK. The expected texts are the shortest decimals that read
 * back as the same double; those marked "not before JDK 19" are where {@code Double.toString} once wrote more digits
 * (JDK-4511638).
 */
@Execution(ExecutionMode.CONCURRENT)
class NumberTextTest {

    private static final byte[] NOTHING = {};
    private static final RawJson RAW = new RawJson();

    /** As a generator writes it, which is as it is spelled byte by byte. */
    private static String text(double value) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (JsonGenerator out = JsonNumbers.FACTORY.createGenerator(ObjectWriteContext.empty(), bytes)) {
            JsonNumbers.write(out, value);
        }
        String text = bytes.toString(StandardCharsets.UTF_8);
        assertEquals(text, RAW.begin(NOTHING).add(value).getValue());
        return text;
    }

    @ParameterizedTest
    @CsvSource({
        "2e23,                    2.0E23,                  not before JDK 19",
        "2.0e-3,                  0.002,                   short",
        "1.1e-5,                  1.1E-5,                  short",
        "2.2250738585072014E-308, 2.2250738585072014E-308, smallest normal",
        "4.9E-324,                4.9E-324,                smallest",
        "1.7976931348623157E308,  1.7976931348623157E308,  greatest",
        "8.41E21,                 8.41E21,                 not before JDK 19",
        "2.98023223876953125E-8,  2.9802322387695312E-8,   a power of two",
        "9007199254740991,        9007199254740991,        2^53 - 1",
        "9007199254740992,        9007199254740992,        2^53",
        "9007199254740994,        9.007199254740994E15,    whole but beyond 2^53",
        "-9007199254740992,       -9007199254740992,       -2^53",
        "0,                       0,                       whole",
        "-0.0,                    -0.0,                    keeps its sign",
        "-1,                      -1,                      whole",
        "0.1,                     0.1,                     shortest",
        "0.30000000000000004,     0.30000000000000004,     shortest",
        "120.00000000000001,      120.00000000000001,      shortest",
        "1e100,                   1.0E100,                 far beyond"})
    void shortestDigits(String written, String expected, String why) {
        assertEquals(expected, text(Double.parseDouble(written)), why);
    }

    @Test
    @Tag("sized")
    void everyTextReadsBackAsTheSameDouble() {
        SplitMix64 random = new SplitMix64(1);
        for (int k = 0; k < TestSize.of(25_000, 100_000); k++) {
            double value = Double.longBitsToDouble(random.nextLong());
            if (Double.isFinite(value)) {
                assertEquals(value, Double.parseDouble(text(value)));
            }
        }
    }

    @Test
    @Tag("sized")
    void everydayNumbersReadBackToo() {
        SplitMix64 random = new SplitMix64(2);
        for (int k = 0; k < TestSize.of(25_000, 100_000); k++) {
            double value = (random.nextLong() >> 11) * 0x1p-40;
            assertEquals(value, Double.parseDouble(text(value)));
            assertEquals(Math.rint(value), Double.parseDouble(text(Math.rint(value))));
        }
    }

    /** Every number of digits, and their ends. */
    @Test
    void wholeNumbersAreSpelledDigitByDigit() {
        for (long power = 1; power < 1_000_000_000_000_000_000L; power *= 10) {
            for (long value : new long[] {power - 1, power, power + 1, 7 * power, -power, 1 - power}) {
                assertEquals(Long.toString(value), RAW.begin(NOTHING).add(value).getValue());
            }
        }
        for (long value : new long[] {Long.MAX_VALUE, Long.MIN_VALUE, Long.MIN_VALUE + 1, 1L << 31, -1L << 31}) {
            assertEquals(Long.toString(value), RAW.begin(NOTHING).add(value).getValue());
        }
    }

    /** More than a generator has room for, at any place of its buffer. */
    @Test
    void aLongValueGoesWholeIntoALine() {
        RAW.begin(RawJson.text("[0"));
        for (int k = 1; k < 5000; k++) {
            RAW.add(',').add(k);
        }
        RAW.add(']');
        for (int before : new int[] {0, 1, 4000, 7990, 8000, 9000}) {
            ByteArrayOutputStream bytes = new ByteArrayOutputStream();
            try (JsonGenerator out = JsonNumbers.FACTORY.createGenerator(ObjectWriteContext.empty(), bytes)) {
                out.writeStartArray();
                out.writeString("x".repeat(before));
                out.writeRawValue(RAW);
                out.writeRawValue(RAW);
                out.writeEndArray();
            }
            assertEquals("[\"" + "x".repeat(before) + "\"," + RAW.getValue() + "," + RAW.getValue() + "]",
                bytes.toString(StandardCharsets.UTF_8));
        }
    }

    @Test
    void aDamagedStateIsNotSpelled() {
        for (double value : new double[] {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY}) {
            IllegalStateException refusal = assertThrows(IllegalStateException.class,
                () -> RAW.begin(NOTHING).add(value));
            assertEquals("the number " + value + " cannot be written: the state is damaged", refusal.getMessage());
        }
    }

    @Test
    void aHeadingThatIsNotSetIsNull() {
        String start = Recorded.of("duel", 1).lines().get(0);

        assertEquals(2, start.split("\"heading\":null", -1).length - 1);
        assertEquals(-1, start.indexOf("NaN"));
    }
}
