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
        for (int k = from; k < to; k++) {
            hash.add((long) bytes[k]);
        }
        for (String[] ofPlayers : texts) {
            for (String text : ofPlayers) {
                hash.add(text == null ? -1L : text.length());
                if (text != null) {
                    text.chars().forEach(c -> hash.add((long) c));
                }
            }
        }
        return StateHash.toHex(hash.value());
    }
}
