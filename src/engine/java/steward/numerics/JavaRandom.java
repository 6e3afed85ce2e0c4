package steward.numerics;

/**
 * Pseudo-random generator with the algorithm of {@code java.util.Random}, which its documentation fixes to the bit. It
 * is a linear congruential generator modulo 2^48 (D. Knuth, "The Art of Computer Programming", volume 2, section
 * 3.2.1). Official games draw their starts from it, so that an official seed names the same start here, on every JDK.
 * Its whole state is one number. For anything else use {@link SplitMix64}.
 *
 * <p>Caveat: the low bits are weak, and seeds that differ little give first draws that differ little.
 */
public final class JavaRandom {

    private static final long MULTIPLIER = 0x5DEECE66DL;
    private static final long INCREMENT = 0xBL;
    private static final long MASK = (1L << 48) - 1;

    private long state;

    /** @param seed any number; only its lowest 48 bits count */
    public JavaRandom(long seed) {
        state = (seed ^ MULTIPLIER) & MASK;
    }

    /** The next 1..32 bits. */
    private int next(int bits) {
        state = state * MULTIPLIER + INCREMENT & MASK;
        return (int) (state >> 48 - bits);
    }

    /**
     * A uniform whole number in {@code [0, bound)}; the number of draws varies.
     *
     * @throws IllegalArgumentException if {@code bound} is not positive
     */
    public int nextInt(int bound) {
        if (bound <= 0) {
            throw new IllegalArgumentException("bound " + bound + ", expected at least 1");
        }
        int bits = next(31);
        if ((bound & -bound) == bound) {              // a power of two: the high bits, because the low ones are weak
            return (int) (bound * (long) bits >> 31);
        }
        int value = bits % bound;
        while (bits - value + (bound - 1) < 0) {      // overflows: in the last, incomplete, multiple of the bound
            bits = next(31);
            value = bits % bound;
        }
        return value;
    }

    /** A uniform multiple of 2^-53 in {@code [0, 1)}; two draws. */
    public double nextDouble() {
        long high = (long) next(26) << 27;
        return (high + next(27)) * 0x1.0p-53;
    }
}
