package steward.league.sequential;

import java.util.function.DoublePredicate;
import steward.league.rating.Normal;

/**
 * 95% confidence range of a bot's mean score, by the likelihood ratio, if the number of seeds was fixed before. With
 * n[i] of n seeds and the share f[i] in cell i, and p the most likely chances with a mean, it contains all means with
 *
 * <pre>sum of n[i] log(f[i] / p[i]) &lt;= t^2 / 2,</pre>
 *
 * t being Student's quantile for n - 1 degrees of freedom (A. B. Owen, "Empirical likelihood ratio confidence intervals
 * for a single functional", Biometrika 75, 1988). Games of a seed belong together. Where all scores are alike an
 * estimate of their variance would tell nothing, and chances do: of n seeds that were all won a mean of m has the ratio
 * n log(1/m).
 *
 * @param low  the lowest, 0..1
 * @param high the highest
 */
public record ScoreRange(double low, double high) {

    /** The standard normal quantile of 0.975. */
    private static final double Z = 1.959963984540054;
    /** Nearest to the end of the scale that is asked about. */
    private static final double NEAREST = 1e-9;
    private static final int HALVINGS = 60;

    /** The range of the mean score; all scores with fewer than two observations. */
    public static ScoreRange of(ScoreCounts scores) {
        if (scores.observations() < 2) {
            return new ScoreRange(0, 1);
        }
        double z = Normal.student(Z, scores.observations() - 1);
        ConstrainedFrequencies likely = new ConstrainedFrequencies(scores.values(), scores.frequencies());
        DoublePredicate within = mean -> ratio(scores, likely.ofMean(mean)) <= z * z / 2;
        return new ScoreRange(within.test(NEAREST) ? 0 : end(within, NEAREST, scores.mean()),
            within.test(1 - NEAREST) ? 1 : end(within, 1 - NEAREST, scores.mean()));
    }

    /** Likelihood of superiority: how probably the mean is above 1/2, if nothing was known before; or NaN. */
    public static double superiority(ScoreCounts scores) {
        double deviation = Math.sqrt(scores.variance() / scores.observations());
        return scores.observations() < 2 ? Double.NaN
            : Normal.below(Normal.ofStudent((scores.mean() - 0.5) / deviation, scores.observations() - 1));
    }

    /** The value between the two where the range ends. */
    private static double end(DoublePredicate within, double outermost, double best) {
        double outside = outermost;
        double inside = best;
        for (int k = 0; k < HALVINGS; k++) {
            double middle = (outside + inside) / 2;
            if (within.test(middle)) {
                inside = middle;
            } else {
                outside = middle;
            }
        }
        return inside;
    }

    private static double ratio(ScoreCounts scores, double... chances) {
        double[] shares = scores.frequencies();
        double ratio = 0;
        for (int k = 0; k < shares.length; k++) {
            ratio += scores.count(k) * StrictMath.log(shares[k] / chances[k]);
        }
        return ratio;
    }
}
