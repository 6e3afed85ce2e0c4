package steward.numerics;

/**
 * Pseudo-random generator of a match: SplitMix64. Its whole state is one 64-bit number, so that a seed names the same
 * match on every machine and JDK. Source: Steele, Lea, Flood, "Fast Splittable Pseudorandom Number Generators", OOPSLA
 * 2014, figure 1, with the mixer "variant 13" of D. Stafford.
 *
 * <p>Caveat: not cryptographically secure.
 */
public final class SplitMix64 {

    /** 2^64 divided by the golden ratio, made odd: the step of the underlying counter. */
    private static final long GOLDEN_GAMMA = 0x9E3779B97F4A7C15L;

    private long state;

    /** @param seed any 64-bit number; two seeds that differ give unrelated sequences */
    public SplitMix64(long seed) {
        state = seed;
    }

    public long nextLong() {
        state += GOLDEN_GAMMA;
        return mix(state);
    }

    /**
     * A uniform whole number in {@code [0, bound)}. Draws until the 63-bit number falls below the largest multiple of
     * the bound, so that all values are equally likely; one draw nearly always suffices.
     *
     * @throws IllegalArgumentException if {@code bound} is not positive
     */
    public int nextInt(int bound) {
        if (bound <= 0) {
            throw new IllegalArgumentException("bound " + bound + ", expected at least 1");
        }
        long limit = Long.MAX_VALUE - Long.MAX_VALUE % bound;
        long bits;
        do {
            bits = nextLong() >>> 1;
        } while (bits >= limit);
        return (int) (bits % bound);
    }

    /**
     * A uniform whole number from {@code low} to {@code high}, both included.
     *
     * @throws IllegalArgumentException if {@code high < low} or the range holds more than 2^31 - 1 numbers
     */
    public int nextInt(int low, int high) {
        long count = (long) high - low + 1;
        if (count < 1 || count > Integer.MAX_VALUE) {
            throw new IllegalArgumentException("range " + low + ".." + high + ", expected 1 to 2^31 - 1 numbers");
        }
        return low + nextInt((int) count);
    }

    /** A uniform multiple of 2^-53 in {@code [0, 1)}. */
    public double nextDouble() {
        return (nextLong() >>> 11) * 0x1.0p-53;
    }

    /** The output mixer alone: a bijection on 64 bits in which every input bit affects every output bit. */
    public static long mix(long z) {
        z = (z ^ (z >>> 30)) * 0xBF58476D1CE4E5B9L;
        z = (z ^ (z >>> 27)) * 0x94D049BB133111EBL;
        return z ^ (z >>> 31);
    }
}
