package steward.numerics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import org.junit.jupiter.api.Test;

/** States that the hash tells apart, and states that it does not. */
class StateHashTest {

    private static long of(double... values) {
        StateHash hash = new StateHash();
        for (double value : values) {
            hash.add(value);
        }
        return hash.value();
    }

    /** By definition h = mix(h + x + gamma): of one number 0 it is mix(gamma), the first SplitMix64 draw of seed 0. */
    @Test
    void itIsTheDocumentedFormula() {
        assertEquals(0, new StateHash().value());
        assertEquals(new SplitMix64(0).nextLong(), new StateHash().add(0L).value());
        long first = SplitMix64.mix(11 + 0x9E3779B97F4A7C15L);
        assertEquals(SplitMix64.mix(first + 12 + 0x9E3779B97F4A7C15L), new StateHash().add(11).add(12).value());
    }

    @Test
    void orderLengthAndEveryBitCount() {
        assertNotEquals(of(1, 2), of(2, 1));
        assertNotEquals(of(1), of(1, 0));
        assertNotEquals(of(1), of(Math.nextUp(1.0)));
        assertNotEquals(of(0.0), of(-0.0));
        assertNotEquals(of(), of(0.0));
    }

    /** Java has 2^53 - 2 NaNs; which of them an operation gives is up to the processor. */
    @Test
    void allNaNsAreTheSame() {
        assertEquals(of(Double.NaN), of(Double.longBitsToDouble(0xFFF8000000000001L)));
        assertEquals(of(Double.NaN), of(Double.longBitsToDouble(0x7FF0000000000123L)));
        assertNotEquals(of(Double.NaN), of(Double.POSITIVE_INFINITY));
    }

    @Test
    void flagsAreOneAndZero() {
        assertEquals(new StateHash().add(1L).add(0L).value(), new StateHash().add(true).add(false).value());
    }

    @Test
    void aResetHashForgets() {
        assertEquals(of(7), new StateHash().add(3).reset().add(7.0).value());
        assertEquals(0, new StateHash().add(3).reset().value());
    }

    @Test
    void itIsWrittenInSixteenDigits() {
        assertEquals("0000000000000000", StateHash.toHex(0));
        assertEquals("ffffffffffffffff", StateHash.toHex(-1));
        assertEquals("000000000000abcd", StateHash.toHex(0xABCD));
        assertEquals("8000000000000000", StateHash.toHex(Long.MIN_VALUE));
    }
}
