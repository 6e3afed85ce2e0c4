package steward.lab.calibration;

/*
 * P(X <= k) for X ~ Binomial(n, p) is summed term by term, each from the one before in logarithms:
 * log t(j) = log t(j - 1) + log((n - j + 1) / j) + log(p / (1 - p)).
 * The bounds are those of C. J. Clopper and E. S. Pearson, "The use of confidence or fiducial limits illustrated in
 * the case of the binomial", Biometrika 26 (1934): the upper bound of the probability at level c, of which k cases in n
 * were seen, is the p with P(X <= k) = 1 - c.
 */

/** Confidence bound for a share that was seen in a sample. */
final class BinomialTail {

    /** The confidence with which a calibration shows a share. */
    static final double CONFIDENCE = 0.99;

    private BinomialTail() { }

    /**
     * Returns how many of the states may have a larger error for the share of all states that have none to be shown: so
     * few that the upper bound of the share that has, at {@link #CONFIDENCE}, is at most 1 - {@code share}.
     *
     * @param share above 0, below 1
     * @return -1 if there are too few states to show it in any case
     */
    static int allowed(int states, double share) {
        double p = 1 - share;
        double odds = StrictMath.log(p) - StrictMath.log1p(-p);
        double log = states * StrictMath.log1p(-p);
        double sum = StrictMath.exp(log);
        int allowed = -1;
        while (sum <= 1 - CONFIDENCE && allowed < states) {
            allowed++;
            int next = allowed + 1;
            log += StrictMath.log((states - next + 1.0) / next) + odds;
            sum += StrictMath.exp(log);
        }
        return allowed;
    }
}
