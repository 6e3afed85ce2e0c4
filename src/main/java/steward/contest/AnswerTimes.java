package steward.contest;

/**
 * Histogram of the times that one bot took to answer, in one game or in many. The buckets have equal relative width, so
 * that histograms of games can be added and do not grow. First answers are counted apart, since they include the start
 * of the program.
 *
 * <p>The buckets are those of HdrHistogram (G. Tene): one for each nanosecond below 2^7 ns, 64 for each power of two
 * above. A time read from them is therefore at most 1/64 too high. The mean and the maximum are exact.
 */
public final class AnswerTimes {

    private static final int BITS = 6;
    /** Buckets for each power of two. */
    private static final int PER_POWER = 1 << BITS;
    /** The last bucket is that of {@code Long.MAX_VALUE}: its highest bit is 62, so 56 shifts, and 127. */
    private static final int BUCKETS = (62 - BITS) * PER_POWER + 2 * PER_POWER;

    private final int[] buckets = new int[BUCKETS];
    private long count;
    private double sum;
    private long worst;
    private int worstTurn;
    private int worstGame;
    private long firstCount;
    private double firstSum;
    private long firstWorst;

    void addFirst(long nanos) {
        firstCount++;
        firstSum += nanos;
        firstWorst = Math.max(firstWorst, nanos);
    }

    void add(long nanos, int turn) {
        buckets[bucket(nanos)]++;
        count++;
        sum += nanos;
        if (nanos > worst || worstTurn == 0) {
            worst = nanos;
            worstTurn = turn;
        }
    }

    void addAll(AnswerTimes game, int number) {
        for (int k = 0; k < BUCKETS; k++) {
            buckets[k] += game.buckets[k];
        }
        boolean earlier = game.worst == worst && number < worstGame;
        if (game.count > 0 && (count == 0 || game.worst > worst || earlier)) {
            worst = game.worst;
            worstTurn = game.worstTurn;
            worstGame = number;
        }
        count += game.count;
        sum += game.sum;
        firstCount += game.firstCount;
        firstSum += game.firstSum;
        firstWorst = Math.max(firstWorst, game.firstWorst);
    }

    /** The number itself below 2 * {@link #PER_POWER}; above, its highest bits and by how much they were shifted. */
    private static int bucket(long nanos) {
        long value = Math.max(0, nanos);
        int shift = Math.max(0, Long.SIZE - 1 - Long.numberOfLeadingZeros(value) - BITS);
        return shift * PER_POWER + (int) (value >>> shift);
    }

    /** The longest time that falls into a bucket. */
    private static long longest(int bucket) {
        int shift = Math.max(0, bucket / PER_POWER - 1);
        long highest = bucket - (long) shift * PER_POWER;
        return (highest << shift) + ((1L << shift) - 1);
    }

    /** Returns how many answers, the first ones of games left out. */
    public long count() {
        return count;
    }

    /** In nanoseconds; NaN without answers. */
    public double meanNanos() {
        return count == 0 ? Double.NaN : sum / count;
    }

    /**
     * The time that the given share of the answers did not exceed: a quantile by the nearest rank.
     *
     * @param share 0..1
     * @return in nanoseconds, at most 1/64 too high; 0 without answers
     */
    public long quantileNanos(double share) {
        long rank = Math.max(1, (long) Math.ceil(share * count));
        long seen = 0;
        for (int k = 0; k < BUCKETS; k++) {
            seen += buckets[k];
            if (seen >= rank) {
                return Math.min(longest(k), worst);
            }
        }
        return worst;
    }

    /** The longest, in nanoseconds. */
    public long worstNanos() {
        return worst;
    }

    /** The game that had the longest, the first of several; 0 without answers. */
    public int worstGame() {
        return worstGame;
    }

    public int worstTurn() {
        return worstTurn;
    }

    /** The mean of the first answers; NaN without games. */
    public double meanFirstNanos() {
        return firstCount == 0 ? Double.NaN : firstSum / firstCount;
    }

    /** The longest of the first answers, in nanoseconds. */
    public long worstFirstNanos() {
        return firstWorst;
    }
}
