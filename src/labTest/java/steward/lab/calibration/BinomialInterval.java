package steward.lab.calibration;

/** Tail probabilities of a binomial distribution, and the interval around a share that was seen in a sample. */
public final class BinomialInterval {

    private BinomialInterval() { }

    /**
     * P(X &lt;= k).
     *
     * @param n number of trials
     * @param p probability of each, above 0 and below 1
     */
    public static double atMost(int k, int n, double p) {
        double log = n * StrictMath.log1p(-p);
        double odds = StrictMath.log(p) - StrictMath.log1p(-p);
        double sum = StrictMath.exp(log);
        for (int j = 1; j <= k; j++) {
            log += StrictMath.log((n - j + 1.0) / j) + odds;
            sum += StrictMath.exp(log);
        }
        return Math.min(1, sum);
    }

    /**
     * True if more cases than a share allows were seen, beyond what chance explains: the two-sided interval at a level
     * around what was seen does not reach it.
     *
     * @param seen   cases with a larger error, of {@code states}
     * @param share  that should have none, above 0, below 1
     * @param level  of the interval, as 0.999
     */
    public static boolean refuted(int seen, int states, double share, double level) {
        return seen > 0 && 1 - atMost(seen - 1, states, 1 - share) < (1 - level) / 2;
    }
}
