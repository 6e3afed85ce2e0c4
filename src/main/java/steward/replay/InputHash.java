package steward.replay;

import steward.numerics.StateHash;

/**
 * A hash of what is recorded but does not follow from the game: of the header, and of what the players did in a turn.
 * Verification plays the game again and compares its outcome; what leaves no trace there (a target that is a little
 * off, a message, the name of a bot) is held by this hash.
 */
final class InputHash {

    private InputHash() {
    }

    /**
     * The bytes, then every text: its length and characters, or -1 for none.
     *
     * @param bytes hold JSON as it is written
     * @param from  the first byte that counts
     * @param to    the byte behind the last
     * @param texts per kind (faults, messages, stderr) and player, or {@code null}
     */
    static String of(byte[] bytes, int from, int to, String[]... texts) {
        StateHash hash = new StateHash();
        add(hash, bytes, from, to);
        for (String[] ofPlayers : texts) {
            for (String text : ofPlayers) {
                add(hash, text);
            }
        }
        return StateHash.toHex(hash.value());
    }

    /** Bytes of JSON. */
    static void add(StateHash hash, byte[] bytes, int from, int to) {
        for (int k = from; k < to; k++) {
            hash.add((long) bytes[k]);
        }
    }

    /** A text's length and characters, or -1 for none. */
    static void add(StateHash hash, String text) {
        hash.add(text == null ? -1L : text.length());
        for (int k = 0; text != null && k < text.length(); k++) {
            hash.add((long) text.charAt(k));
        }
    }
}
