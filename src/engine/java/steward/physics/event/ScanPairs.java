package steward.physics.event;

/**
 * Pairs of n bodies in the order in which the official referee scans them, i = n-1..1, j = i-1..0. A set of pairs is
 * held as the bits of a long. Immutable, one instance for each number of bodies.
 */
public final class ScanPairs {

    /** The maximum number of bodies whose pairs fit into 64 bits. */
    public static final int MOST_BODIES = 11;

    private static final ScanPairs[] OF = new ScanPairs[MOST_BODIES + 1];

    static {
        for (int bodies = 0; bodies <= MOST_BODIES; bodies++) {
            OF[bodies] = new ScanPairs(bodies);
        }
    }

    private final int[] first;
    private final int[] second;
    private final long[] pairsOf;

    private ScanPairs(int bodies) {
        first = new int[bodies * Math.max(0, bodies - 1) / 2];
        second = new int[first.length];
        pairsOf = new long[bodies];
        int pair = 0;
        for (int i = bodies - 1; i > 0; i--) {
            for (int j = i - 1; j >= 0; j--) {
                first[pair] = i;
                second[pair] = j;
                pairsOf[i] |= 1L << pair;
                pairsOf[j] |= 1L << pair;
                pair++;
            }
        }
    }

    /**
     * The pairs of {@code bodies} bodies.
     *
     * @param bodies 0..{@value #MOST_BODIES}
     * @throws IllegalArgumentException if there are more
     */
    public static ScanPairs of(int bodies) {
        if (bodies > MOST_BODIES) {
            throw new IllegalArgumentException(bodies + " bodies, expected at most " + MOST_BODIES);
        }
        return OF[bodies];
    }

    /** The body of a pair that comes first in the scan: the one with the higher index. */
    public int first(int pair) {
        return first[pair];
    }

    /** The other body of a pair. */
    public int second(int pair) {
        return second[pair];
    }

    public long pairsOf(int body) {
        return pairsOf[body];
    }

    public long all() {
        return (1L << first.length) - 1;
    }
}
