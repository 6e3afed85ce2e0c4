package steward.league.rating;

/**
 * Confidence bars that hold at all moments together, so that one may look at them, and stop, at any time.
 *
 * <p>An estimate with variance V has collected the information I = 1/V. Estimates at different moments have the
 * covariance of the later variance, so that I times the error is a Brownian motion in the time I (C. Jennison and B. W.
 * Turnbull, "Group-sequential analysis incorporating covariate information", Journal of the American Statistical
 * Association 92, 1997). A Brownian motion W stays for all times within
 *
 * <pre>|W(I)| &lt;= sqrt((I + r) log((I + r) / (r alpha^2)))</pre>
 *
 * with probability 1 - alpha, for any r &gt; 0 (H. Robbins, "Statistical methods related to the law of the iterated
 * logarithm", Annals of Mathematical Statistics 41, 1970: a mixture of likelihood ratios over a normal drift of
 * variance 1/r). Divided by I it is the bar. Since the variance is estimated, the bar is an asymptotic confidence
 * sequence (I. Waudby-Smith, D. Arbour, R. Sinha, E. H. Kennedy and A. Ramdas, "Time-uniform central limit theory and
 * asymptotic confidence sequences", Annals of Statistics 52, 2024). To hold from the first look on, it is widened as
 * Student's t is against the normal distribution.
 */
public final class AnytimeBar {

    /** 1 - the probability with which a bar holds. */
    public static final double ALPHA = 0.05;
    /**
     * Standard deviations, in Elo, at which r = I: a bar is narrowest, against others of its kind, where the deviation
     * is about a third of it. The first is for bars of 30 Elo, the last for bots that win nearly always, whose games
     * tell little of the size of the difference, but soon its sign.
     */
    private static final double[] SCALES = {28, 120, 500};
    /**
     * Shares of the permitted miss that each bar has: together they hold with the whole, and the narrowest one is
     * taken.
     */
    private static final double[] PARTS = {0.8, 0.1, 0.1};

    private AnytimeBar() { }

    /**
     * Half the width.
     *
     * @param variance of the estimate, in natural units of rating
     * @param freedom  degrees of freedom of the variance
     * @param alpha    the probability with which the truth may ever be outside
     */
    public static double of(double variance, double freedom, double alpha) {
        return Math.sqrt(variance) * Normal.student(deviations(variance, alpha), freedom);
    }

    /** Half the width in standard deviations of an estimate whose variance is known. */
    public static double deviations(double variance, double alpha) {
        double narrowest = Double.POSITIVE_INFINITY;
        for (int k = 0; k < SCALES.length; k++) {
            double scale = RatingFit.ELO / SCALES[k];
            double ratio = scale * scale * variance;
            narrowest = Math.min(narrowest, Math.sqrt((1 + ratio)
                * (StrictMath.log1p(1 / ratio) - 2 * StrictMath.log(alpha * PARTS[k]))));
        }
        return narrowest;
    }
}
