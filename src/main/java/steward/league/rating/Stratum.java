package steward.league.rating;

import java.util.Arrays;
import java.util.List;

/**
 * The clusters of one group of bots. A cluster is all games of one seed: they share the seed and do not count as
 * independent. Clusters that went alike are kept once with their number, a pattern.
 *
 * <p>A pattern has three numbers for each pair of the group, pairs in the order (0,1), (0,2), ..., (1,2), ...: games,
 * points of the first in them, ties among them, all in whole games of two.
 */
public final class Stratum {

    private static final int FIRST = 8;

    /** The group's bots, ascending; their places in the fit. */
    final int[] bots;
    /** What one comparison weighs, in games of two. */
    final double weight;
    /** Patterns, each with its numbers. */
    double[][] patterns = new double[FIRST][];
    long[] counts = new long[FIRST];
    int size;
    long clusters;
    /** Sums over all clusters, as in a pattern. */
    final double[] sums;

    /**
     * @param weight of one comparison of two bots in one game: 1, in games of n players 2/n
     * @param bots   of the group, ascending
     */
    public Stratum(double weight, int... bots) {
        this.weight = weight;
        this.bots = bots.clone();
        sums = new double[3 * pairs()];
    }

    int pairs() {
        return bots.length * (bots.length - 1) / 2;
    }

    /**
     * Adds a way for a cluster to go.
     *
     * @return its number
     */
    public int pattern(double... numbers) {
        if (numbers.length != sums.length) {
            throw new IllegalArgumentException("found " + numbers.length + " numbers, expected " + sums.length);
        }
        if (size == counts.length) {
            patterns = Arrays.copyOf(patterns, 2 * size);
            counts = Arrays.copyOf(counts, 2 * size);
        }
        patterns[size] = numbers.clone();
        return size++;
    }

    /** Adds clusters that went so. */
    public void add(int pattern, long count) {
        counts[pattern] += count;
        clusters += count;
        double[] numbers = patterns[pattern];
        for (int k = 0; k < numbers.length; k++) {
            sums[k] += count * numbers[k];
        }
    }

    /** How many clusters there are. */
    public long clusters() {
        return clusters;
    }

    /** Takes all clusters away; the patterns stay. */
    public void clear() {
        Arrays.fill(counts, 0);
        Arrays.fill(sums, 0);
        clusters = 0;
    }

    /** Is shown pairs. */
    interface PairVisitor {
        /**
         * @param stratum its number in the list
         * @param pair    its number in the stratum
         * @param low     the first bot
         * @param high    the second
         */
        void pair(int stratum, int pair, int low, int high);
    }

    /** Goes through all pairs of some strata. */
    static void each(List<Stratum> strata, PairVisitor visitor) {
        for (int q = 0; q < strata.size(); q++) {
            int[] group = strata.get(q).bots;
            int k = 0;
            for (int i = 0; i < group.length; i++) {
                for (int j = i + 1; j < group.length; j++) {
                    visitor.pair(q, k++, group[i], group[j]);
                }
            }
        }
    }
}
