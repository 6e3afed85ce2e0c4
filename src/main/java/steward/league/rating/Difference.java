package steward.league.rating;

/**
 * Estimated difference of two ratings with its variance and degrees of freedom.
 *
 * @param value   in natural units: the logarithm of wins per loss
 * @param freedom degrees of freedom of the variance
 * @param single  how much of a single pairing it is: the sum of the squares of the shares of the variance that
 *                seeds have of which one pairing alone enters the difference, 1 where one has all of it
 * @param bound   where the bar is one-sided, since a bot has won or lost nearly everything: its end, below a positive
 *                value and above a negative one, in natural units; otherwise NaN
 */
public record Difference(double value, double variance, double freedom, double single, double bound) {

    /** The standard normal quantile of 0.975: a bound is as sure as either end of a bar. */
    static final double Z = 1.959963984540054;
    /** Degrees of freedom that 30 clusters have; see {@link #ofBar}. */
    private static final double LARGE = 29;
    /** Less than this is no difference to a single pairing but rounding. */
    private static final double ROUNDING = 1e-9;

    /** A difference with a bar of two sides. */
    public Difference(double value, double variance, double freedom, double single) {
        this(value, variance, freedom, single, Double.NaN);
    }

    /** Nothing is known. */
    static final Difference NONE = new Difference(Double.NaN, Double.POSITIVE_INFINITY, 1, 1);

    /** The difference of a rating to itself. */
    static final Difference ZERO = new Difference(0, 0, RatingFit.CERTAIN, 1);

    /** A difference of which a bound is all that can be told: infinite, with its sign. */
    static Difference beyond(double end, boolean ahead) {
        return new Difference(ahead ? Double.POSITIVE_INFINITY : Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY, 1,
            1, end);
    }

    /** A copy with a bar of one side. */
    Difference oneSided(double end) {
        return new Difference(value, variance, freedom, single, end);
    }

    /** The estimate without any bar. */
    Difference unknown() {
        return new Difference(value, Double.POSITIVE_INFINITY, freedom, single);
    }

    /** True if nothing but a bound can be told: that the difference is more, or if it is below 0 less, than this. */
    public boolean isOneSided() {
        return !Double.isNaN(bound);
    }

    /** The bound in Elo; NaN where the bar has two sides. */
    public double boundElo() {
        return RatingFit.ELO * bound;
    }

    /** True if a difference in Elo is within the bar, or on the right side of the bound. */
    public boolean holds(double elo) {
        return isOneSided() ? value > 0 ? elo >= boundElo() : elo <= boundElo() : !(Math.abs(elo() - elo) > bar());
    }

    /** In Elo; a bar of so much says that nothing is known. */
    public static final double MOST_BAR = 9999;

    /** True if a bar says anything. */
    public static boolean isKnown(double bar) {
        return bar < MOST_BAR;
    }

    public double elo() {
        return RatingFit.ELO * value;
    }

    /** Half the width of the 95% bar in Elo, for one look at a number of games that was fixed before. */
    public double bar() {
        return bar(Z);
    }

    /** Half the width of the bar in Elo that holds as surely as z standard deviations. */
    public double bar(double z) {
        return Math.min(MOST_BAR, RatingFit.ELO * Math.sqrt(variance) * ofBar(z));
    }

    /**
     * Student's t for few clusters. From 30 on a single pairing needs the normal distribution alone: the variance of a
     * share of points is known when the share is, nearly. A sum over pairings has no such help, so that Student's t
     * stays for what is not of a single one.
     */
    private double ofBar(double z) {
        if (freedom < LARGE) {
            return Normal.student(z, freedom);
        }
        return single > 1 - ROUNDING ? z : Normal.student(z, freedom / (1 - single));
    }

    /** Half the width in Elo of the 95% bar that holds at all looks at once. */
    public double anytimeBar() {
        return anytimeBar(AnytimeBar.ALPHA);
    }

    /** Returns the bar for another probability to be ever outside. */
    public double anytimeBar(double alpha) {
        return variance == 0 ? 0 : Math.min(MOST_BAR, RatingFit.ELO * AnytimeBar.of(variance, freedom, alpha));
    }

    /** The likelihood of superiority: how probably the first is the better one, if nothing was known before. */
    public double superiority() {
        return Normal.below(Normal.ofStudent(value / Math.sqrt(variance), freedom));
    }
}
