package steward.numerics;

/**
 * 64-bit hash of a sequence of numbers, which depends on their order. Each number x changes the hash h to {@code mix(h
 * + x + gamma)}, with the mixer of {@link SplitMix64}. Doubles enter by their bits, so that two states have the same
 * hash only if they agree to the last bit (and -0.0 differs from 0.0).
 *
 * <p>Caveat: it detects differences, but is not collision-resistant against an attacker.
 */
public final class StateHash {

    private static final long GAMMA = 0x9E3779B97F4A7C15L;

    private long hash;

    /** Adds a whole number, all 64 bits. */
    public StateHash add(long value) {
        hash = SplitMix64.mix(hash + value + GAMMA);
        return this;
    }

    /** Adds the bits of the number; every NaN counts as the same one. */
    public StateHash add(double value) {
        return add(Double.doubleToLongBits(value));
    }

    /** Adds 1 for true, 0 for false. */
    public StateHash add(boolean value) {
        return add(value ? 1L : 0L);
    }

    /** The hash of all that was added, in this order. */
    public long value() {
        return hash;
    }

    /** Back to the empty sequence, whose hash is 0. */
    public StateHash reset() {
        hash = 0;
        return this;
    }

    /** A hash as it is written in replays: 16 lower-case hexadecimal digits. */
    public static String toHex(long hash) {
        String digits = Long.toHexString(hash);
        return "0".repeat(16 - digits.length()) + digits;
    }
}
