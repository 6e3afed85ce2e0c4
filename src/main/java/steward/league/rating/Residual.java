package steward.league.rating;

/**
 * What the games between two bots say beside their ratings.
 *
 * @param share    of the points of the first; NaN without games
 * @param expected as the ratings tell
 * @param clusters in which they met
 * @param z        the difference of the two in standard deviations of the share, from the spread of its clusters; 0
 *                 where there are too few
 */
public record Residual(double share, double expected, long clusters, double z) {

    /** Half the probability to be called a surprise by chance, if this were the only pair. */
    private static final double TAIL = 0.025;

    /** Whether it is more than chance would do once in twenty leagues, where so many pairs are looked at. */
    public boolean isSurprise(int pairs) {
        return Math.abs(z) > Normal.above(TAIL / Math.max(1, pairs));
    }
}
