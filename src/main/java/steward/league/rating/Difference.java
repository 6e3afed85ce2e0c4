package steward.league.rating;

/**
 * A difference of ratings and how sure it is.
 *
 * @param value    in natural units: the logarithm of wins per loss
 * @param variance of it
 * @param freedom  degrees of freedom of the variance
 */
public record Difference(double value, double variance, double freedom) {

    /** The standard normal quantile of 0.975. */
    private static final double Z = 1.959963984540054;
    /** From so many degrees of freedom on, which 30 clusters have, bars are those of the normal distribution. */
    private static final double LARGE = 29;

    /** In Elo; a bar of so much says that nothing is known. */
    public static final double MOST_BAR = 9999;

    /** Whether a bar says anything. */
    public static boolean isKnown(double bar) {
        return bar < MOST_BAR;
    }

    /** The difference in Elo. */
    public double elo() {
        return RatingFit.ELO * value;
    }

    /** Half the width of the 95% bar in Elo, for one look at a number of games that was fixed before. */
    public double bar() {
        return bar(Z);
    }

    /** Half the width of the bar in Elo that holds as surely as z standard deviations. */
    public double bar(double z) {
        return Math.min(MOST_BAR,
            RatingFit.ELO * Math.sqrt(variance) * (freedom >= LARGE ? z : Normal.student(z, freedom)));
    }

    /** Half the width in Elo of the 95% bar that holds at all looks at once. */
    public double anytimeBar() {
        return anytimeBar(AnytimeBar.ALPHA);
    }

    /** The same for another probability to be ever outside. */
    public double anytimeBar(double alpha) {
        return Math.min(MOST_BAR, RatingFit.ELO * AnytimeBar.of(variance, freedom, alpha));
    }

    /** The likelihood of superiority: how probably the first is the better one, if nothing was known before. */
    public double superiority() {
        return Normal.below(Normal.ofStudent(value / Math.sqrt(variance), freedom));
    }
}
