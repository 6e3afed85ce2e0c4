package steward.league.rating;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;

/**
 * Clusters in which the same groups of bots have played. A cluster is all games of one seed between bots that these
 * games connect: they share the seed and are not independent. Most clusters are games of one group. Clusters with the
 * same results are kept once with their number, as a pattern.
 *
 * <p>A pattern has three numbers for each pair of bots of each group: games, points of the first bot, ties, all in
 * units of a game of two. Pairs are in the order (0,1), (0,2), ..., (1,2), ...
 */
public final class Stratum {

    private static final int FIRST = 8;

    /** All bots, ascending; their places in the fit. */
    final int[] bots;
    /** Bots that play together, each ascending. */
    final int[][] groups;
    /** By pair: the number of its group. */
    final int[] group;
    /** By pair: the place of its first bot in {@link #bots}. */
    final int[] low;
    /** By pair: the place of its second bot. */
    final int[] high;
    /** Weight of one comparison, in games of two. */
    final double weight;
    /** Patterns, each with its numbers. */
    double[][] patterns = new double[FIRST][];
    long[] counts = new long[FIRST];
    int size;
    long clusters;
    /** Sums over all clusters, as in a pattern. */
    final double[] sums;

    /**
     * Games of one group.
     *
     * @param weight of one comparison of two bots in one game: 1, in games of n players 2/n
     * @param bots   of the group, ascending
     */
    public Stratum(double weight, int... bots) {
        this(weight, new int[][] {bots});
    }

    /**
     * Games of some groups that share their seeds.
     *
     * @param weight of one comparison of two bots in one game
     * @param groups each ascending
     */
    public Stratum(double weight, int[][] groups) {
        this.weight = weight;
        this.groups = Stream.of(groups).map(int[]::clone).toArray(int[][]::new);
        bots = Stream.of(groups).flatMapToInt(Arrays::stream).sorted().distinct().toArray();
        int pairs = Stream.of(groups).mapToInt(each -> each.length * (each.length - 1) / 2).sum();
        group = new int[pairs];
        low = new int[pairs];
        high = new int[pairs];
        sums = new double[3 * pairs];
        int k = 0;
        for (int number = 0; number < groups.length; number++) {
            for (int i = 0; i < groups[number].length; i++) {
                for (int j = i + 1; j < groups[number].length; j++) {
                    group[k] = number;
                    low[k] = Arrays.binarySearch(bots, groups[number][i]);
                    high[k++] = Arrays.binarySearch(bots, groups[number][j]);
                }
            }
        }
    }

    int pairs() {
        return low.length;
    }

    /** True if a pair is of these two bots. */
    boolean isOf(int pair, int one, int other) {
        return bots[low[pair]] == Math.min(one, other) && bots[high[pair]] == Math.max(one, other);
    }

    /** Adds a way for a cluster to go. @return its number */
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
            Stratum stratum = strata.get(q);
            for (int k = 0; k < stratum.pairs(); k++) {
                visitor.pair(q, k, stratum.bots[stratum.low[k]], stratum.bots[stratum.high[k]]);
            }
        }
    }
}
