package steward.replay;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;
import steward.Internal;
import steward.numerics.StateHash;

/**
 * A hash of what is recorded but does not follow from the game: of the header, and of what the players did in a turn.
 * Verification plays the game again and compares its outcome; what leaves no trace there (a target that is a little
 * off, a message, the name of a bot) is held by this hash.
 *
 * <p>Bytes of JSON enter it eight at a time, the first as the lowest, the last ones filled up with zeros, and then
 * their number. In format 1 of a replay they entered it one by one, signed, without their number.
 */
@Internal
public final class InputHash {

    private static final VarHandle EIGHT_BYTES =
        MethodHandles.byteArrayViewVarHandle(long[].class, ByteOrder.LITTLE_ENDIAN);
    private static final int BYTE_BY_BYTE = 1;

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
        for (; at + Long.BYTES <= to; at += Long.BYTES) {
            hash.add((long) EIGHT_BYTES.get(bytes, at));
        }
        long rest = 0;
        for (int k = to - 1; k >= at; k--) {
            rest = rest << Byte.SIZE | bytes[k] & 0xFF;
        }
        hash.add(rest).add((long) to - from);
    }

    /** A text's length and characters, or -1 for none. */
    public static void add(StateHash hash, String text) {
        hash.add(text == null ? -1L : text.length());
        for (int k = 0; text != null && k < text.length(); k++) {
            hash.add((long) text.charAt(k));
        }
    }
}
