package steward.league.rating;

/**
 * Deviation of two bots' results from what their ratings predict.
 *
 * @param share    of the points of the first; NaN without games
 * @param expected as the ratings tell; NaN where they cannot be compared
 * @param clusters in which they met
 * @param z        the difference of the two in standard deviations of the share, from the spread of its clusters; 0
 *                 where there are too few
 */
public record Residual(double share, double expected, long clusters, double z) {

    /** Half the probability to be called a surprise by chance, if this were the only pair. */
    private static final double TAIL = 0.025;

    /** A smaller difference of shares is of no use to anyone, however sure it is. */
    private static final double LEAST = 0.005;

    /**
     * True if it is more than chance would do once in twenty leagues, where so many pairs are looked at, and at least
     * half a percent of the points.
     */
    public boolean isSurprise(int pairs) {
        return Math.abs(share - expected) >= LEAST && Math.abs(z) > Normal.above(TAIL / Math.max(1, pairs));
    }
}
