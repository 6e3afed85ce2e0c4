package steward.replay;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;
import steward.numerics.SplitMix64;
import steward.numerics.StateHash;

/**
 * Hash of a line of a replay, which detects damage and edits. Verification plays the game again and compares the
 * outcome; fields without effect on it (a slightly different target, a message, the name of a bot) are protected by
 * this hash alone. An edit after which the hash was computed again is not detected: signatures are for that.
 *
 * <p>Every complete block of 32 bytes feeds four independent hashes, eight bytes each (little-endian), because a
 * processor computes four at once in little more time than one; their values enter the hash first. Then come the
 * remaining bytes, eight at a time, the last word padded with zeros, and the count of all bytes.
 */
public final class InputHash {

    private static final VarHandle EIGHT_BYTES =
        MethodHandles.byteArrayViewVarHandle(long[].class, ByteOrder.LITTLE_ENDIAN);
    private static final int FOUR_TIMES_EIGHT = 32;
    /** The increment of {@link StateHash}. */
    private static final long GAMMA = 0x9E3779B97F4A7C15L;

    private InputHash() { }

    /**
     * The hash of bytes alone.
     *
     * @param bytes hold JSON as it is written
     * @param from  the first byte that counts
     * @param to    the byte behind the last
     */
    public static String of(byte[] bytes, int from, int to) {
        StateHash hash = new StateHash();
        add(hash, bytes, from, to);
        return StateHash.toHex(hash.value());
    }

    /** Adds bytes of JSON. */
    public static void add(StateHash hash, byte[] bytes, int from, int to) {
        int at = from;
        if (to - at >= FOUR_TIMES_EIGHT) {
            at = addFourAtOnce(hash, bytes, at, to);
        }
        for (; at + Long.BYTES <= to; at += Long.BYTES) {
            hash.add((long) EIGHT_BYTES.get(bytes, at));
        }
        long rest = 0;
        for (int k = to - 1; k >= at; k--) {
            rest = rest << Byte.SIZE | bytes[k] & 0xFF;
        }
        hash.add(rest).add((long) to - from);
    }

    /** @return the end of the last complete block of 32 bytes */
    private static int addFourAtOnce(StateHash hash, byte[] bytes, int from, int to) {
        long a = 0;
        long b = 0;
        long c = 0;
        long d = 0;
        int at = from;
        for (; at + FOUR_TIMES_EIGHT <= to; at += FOUR_TIMES_EIGHT) {
            a = SplitMix64.mix(a + GAMMA + (long) EIGHT_BYTES.get(bytes, at));
            b = SplitMix64.mix(b + GAMMA + (long) EIGHT_BYTES.get(bytes, at + Long.BYTES));
            c = SplitMix64.mix(c + GAMMA + (long) EIGHT_BYTES.get(bytes, at + 2 * Long.BYTES));
            d = SplitMix64.mix(d + GAMMA + (long) EIGHT_BYTES.get(bytes, at + 3 * Long.BYTES));
        }
        hash.add(a).add(b).add(c).add(d);
        return at;
    }
}
