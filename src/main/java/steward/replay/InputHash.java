package steward.replay;

import steward.numerics.StateHash;

/**
 * A hash of what went into a turn: the bytes of its commands as they are written, then per player the fault (its
 * length and characters, or -1 for none). The state's hash does not cover them: a target that is a little off may leave
 * no trace in the turn.
 */
final class InputHash {

    private InputHash() {
    }

    /**
     * @param bytes  hold the JSON array of commands
     * @param from   its first byte
     * @param to     the byte behind its last
     * @param faults per player, or {@code null}
     */
    static String of(byte[] bytes, int from, int to, String[] faults) {
        StateHash hash = new StateHash();
        for (int k = from; k < to; k++) {
            hash.add((long) bytes[k]);
        }
        for (String fault : faults) {
            hash.add(fault == null ? -1L : fault.length());
            if (fault != null) {
                fault.chars().forEach(c -> hash.add((long) c));
            }
        }
        return StateHash.toHex(hash.value());
    }
}
