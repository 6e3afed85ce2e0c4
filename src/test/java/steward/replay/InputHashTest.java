package steward.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.math.BigInteger;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import steward.numerics.SplitMix64;

/** Replays written today are to be verified for good: the hash of a line, byte for byte as its Javadoc says. */
class InputHashTest {

    private static final long GAMMA = 0x9E3779B97F4A7C15L;

    /** In whole numbers of any size, from the last byte of each eight to the first. */
    private static String expected(byte[] bytes, int from, int to) {
        long hash = 0;
        for (int at = from; at < to - (to - from) % 8; at += 8) {
            hash = SplitMix64.mix(hash + GAMMA + number(bytes, at, at + 8));
        }
        hash = SplitMix64.mix(hash + GAMMA + number(bytes, to - (to - from) % 8, to));
        hash = SplitMix64.mix(hash + GAMMA + (to - from));
        return String.format("%016x", hash);
    }

    private static long number(byte[] bytes, int from, int to) {
        BigInteger number = BigInteger.ZERO;
        for (int k = to - 1; k >= from; k--) {
            number = number.multiply(BigInteger.valueOf(256)).add(BigInteger.valueOf(Byte.toUnsignedInt(bytes[k])));
        }
        return number.longValue();
    }

    private static byte[] bytes(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 7, 8, 9, 15, 16, 17, 31})
    void bytesEnterEightAtATime(int length) {
        byte[] bytes = new byte[length + 3];
        for (int k = 0; k < bytes.length; k++) {
            bytes[k] = (byte) (37 * k + 200);
        }
        assertEquals(expected(bytes, 3, length + 3), InputHash.of(bytes, 3, length + 3));
    }

    @Test
    void theirNumberCounts() {
        assertNotEquals(InputHash.of(bytes("a"), 0, 1), InputHash.of(bytes("a\0"), 0, 2));
        assertNotEquals(InputHash.of(bytes(""), 0, 0), InputHash.of(new byte[8], 0, 8));
    }

    /** Four hashes of eight bytes each of every 32, then the rest as before. */
    @ParameterizedTest
    @ValueSource(ints = {0, 7, 31, 32, 33, 63, 64, 100, 1000})
    void fromThirtyTwoBytesOnFourEnterAtOnce(int length) {
        byte[] bytes = new byte[length + 3];
        for (int k = 0; k < bytes.length; k++) {
            bytes[k] = (byte) (37 * k + 200);
        }
        int to = length + 3;
        int rest = 3 + length / 32 * 32;
        long[] four = new long[4];
        for (int at = 3; at < rest; at += 8) {
            int lane = (at - 3) / 8 % 4;
            four[lane] = SplitMix64.mix(four[lane] + GAMMA + number(bytes, at, at + 8));
        }
        long hash = 0;
        for (long each : rest > 3 ? four : new long[0]) {
            hash = SplitMix64.mix(hash + GAMMA + each);
        }
        int last = to - (to - rest) % 8;
        for (int at = rest; at < last; at += 8) {
            hash = SplitMix64.mix(hash + GAMMA + number(bytes, at, at + 8));
        }
        hash = SplitMix64.mix(hash + GAMMA + number(bytes, last, to));
        hash = SplitMix64.mix(hash + GAMMA + length);
        assertEquals(String.format("%016x", hash), InputHash.of(bytes, 3, to));
    }

    /** Written down once, so that no change of both sides goes unseen. */
    @Test
    void knownAnswers() {
        byte[] longer = bytes("0123456789".repeat(7));
        assertEquals("d608b8d73fb9f721", InputHash.of(longer, 0, longer.length));
    }
}
