package steward.numerics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import tools.jackson.core.io.NumberOutput;

/** Digits are those of Jackson's writer, whose own tests know the answers; and nothing where another must write. */
@Execution(ExecutionMode.CONCURRENT)
class ShortestDecimalTest {

    private final char[] digits = new char[ShortestDecimal.MAXIMUM_LENGTH];

    private String text(double value) {
        int count = ShortestDecimal.write(value, digits);
        return count == ShortestDecimal.UNSUPPORTED ? "elsewhere" : new String(digits, 0, count);
    }

    @ParameterizedTest
    @CsvSource({"0.1", "0.30000000000000004", "120.00000000000001", "-12.75", "0.001", "0.0010000000000000002",
        "9999999.999999998", "3.141592653589793", "-0.0123", "1.0000000000000002", "100000.5", "0.3"})
    void shortest(String written) {
        assertEquals(written, text(Double.parseDouble(written)));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, -0.0, 1, -7, 1e7, 1e7 + 0.5, 0.5, 0.25, 9.999999999999998e-4, Double.MIN_VALUE, 1e300,
        Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY})
    void othersAreWrittenElsewhere(double value) {
        assertEquals("elsewhere", text(value));
    }

    @Test
    @Tag("slow")
    void theSameAsJackson() {
        SplitMix64 random = new SplitMix64(20);
        long least = Double.doubleToLongBits(1e-3);
        long span = Double.doubleToLongBits(1e7) - least;
        int written = 0;
        for (int k = 0; k < 300_000; k++) {
            double value = switch (k % 4) {
                case 0 -> 360 * random.nextDouble();
                case 1 -> Double.longBitsToDouble(least + (long) (random.nextDouble() * span));
                case 2 -> -random.nextInt(1_000_000) / 1000.0;
                default -> Math.nextUp(random.nextInt(1, 100_000) / (double) (1 << random.nextInt(10)));
            };
            if (ShortestDecimal.write(value, digits) != ShortestDecimal.UNSUPPORTED) {
                assertEquals(NumberOutput.toString(value, true), text(value), "seed 20, number " + k);
                written++;
            }
        }
        assertTrue(written > 290_000, () -> "hardly any was tried");
    }
}
