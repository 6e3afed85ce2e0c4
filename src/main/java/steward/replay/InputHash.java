package steward.replay;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;
import steward.Internal;
import steward.numerics.SplitMix64;
import steward.numerics.StateHash;

/**
 * A hash of a line, or in formats 1 and 2 of what is recorded in it but does not follow from the game. Verification
 * plays the game again and compares its outcome; what leaves no trace there (a target that is a little off, a message,
 * the name of a bot) is held by this hash. It finds what was damaged or edited, and resists nobody who computes it
 * anew: that is for signatures.
 *
 * <p>Bytes of JSON enter it eight at a time, the first as the lowest, the last ones filled up with zeros, and then
 * their number. In format 1 of a replay they entered it one by one, signed, without their number. From format 3 on
 * every whole 32 bytes enter four hashes, eight bytes each, that are computed side by side, because a processor does
 * four at once in little more time than one; they enter the hash first, then the rest as before.
 */
@Internal
public final class InputHash {

    private static final VarHandle EIGHT_BYTES =
        MethodHandles.byteArrayViewVarHandle(long[].class, ByteOrder.LITTLE_ENDIAN);
    private static final int BYTE_BY_BYTE = 1;
    private static final int FOUR_AT_ONCE = 3;
    private static final int FOUR_TIMES_EIGHT = 32;
    /** The increment of {@link StateHash}. */
    private static final long GAMMA = 0x9E3779B97F4A7C15L;

    private InputHash() {
    }

    /**
     * The bytes, then every text: its length and characters, or -1 for none.
     *
     * @param format of the replay
     * @param bytes hold JSON as it is written
     * @param from  the first byte that counts
     * @param to    the byte behind the last
     * @param texts per kind (faults, messages, stderr) and player, or {@code null}
     */
    public static String of(int format, byte[] bytes, int from, int to, String[]... texts) {
        StateHash hash = new StateHash();
        add(hash, format, bytes, from, to);
        for (String[] ofPlayers : texts) {
            for (String text : ofPlayers) {
                add(hash, text);
            }
        }
        return StateHash.toHex(hash.value());
    }

    /** Bytes of JSON. */
    public static void add(StateHash hash, int format, byte[] bytes, int from, int to) {
        int at = from;
        if (format == BYTE_BY_BYTE) {
            while (at < to) {
                hash.add((long) bytes[at++]);
            }
            return;
        }
        if (format >= FOUR_AT_ONCE && to - at >= FOUR_TIMES_EIGHT) {
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

    /** @return where the last whole 32 bytes end */
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

    /** A text's length and characters, or -1 for none. */
    public static void add(StateHash hash, String text) {
        hash.add(text == null ? -1L : text.length());
        for (int k = 0; text != null && k < text.length(); k++) {
            hash.add((long) text.charAt(k));
        }
    }
}
