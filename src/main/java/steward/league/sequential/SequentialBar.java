package steward.league.sequential;

import java.util.function.DoubleFunction;
import java.util.function.DoublePredicate;
import java.util.function.DoubleUnaryOperator;
import steward.league.rating.AnytimeBar;

/**
 * Range of a bot's true score that holds at all looks, and so where a test has stopped. With n[i] observations and the
 * share f[i] in cell i, and p the most likely chances under the value that is asked about, it has all values with
 *
 * <pre>sum of n[i] log(f[i] / p[i]) &lt;= z^2 / 2,</pre>
 *
 * z being the standard deviations of {@link AnytimeBar}. That is the likelihood ratio of {@link Gsprt} against the best
 * value. Where all scores are alike an estimate of their variance would tell nothing, and chances do: of n observations
 * that were all 1 a mean of m has the ratio n log(1/m).
 *
 * @param low  the lowest, -infinity where any is possible
 * @param high the highest, infinity where any is possible
 */
public record SequentialBar(double low, double high) {

    /** Nearest to the end of the scale that is asked about. */
    private static final double NEAREST = 1e-9;
    /** In standard deviations of an observation. */
    private static final double FARTHEST = 1e3;
    private static final int HALVINGS = 60;
    /** Of the score by the natural rating, where both bots are even. */
    private static final double SLOPE = 0.25;

    /** The range of the mean score. Expects at least one observation. */
    public static SequentialBar ofMean(ScoreCounts scores) {
        return range(scores, NEAREST, scores.mean(), 1 - NEAREST, likely(scores)::ofMean);
    }

    /** The range of the mean score's distance from 1/2, in standard deviations of an observation. */
    static SequentialBar ofDeviations(ScoreCounts scores) {
        double[] shares = scores.frequencies();
        double mean = 0;
        double square = 0;
        for (int k = 0; k < shares.length; k++) {
            double distance = scores.values()[k] - 0.5;
            mean += shares[k] * distance;
            square += shares[k] * distance * distance;
        }
        return range(scores, -FARTHEST, mean / Math.sqrt(square - mean * mean), FARTHEST, likely(scores)::ofDeviations);
    }

    /** True if any lower value is possible. */
    public boolean isOpenBelow() {
        return low == Double.NEGATIVE_INFINITY;
    }

    /** True if any higher value is possible. */
    public boolean isOpenAbove() {
        return high == Double.POSITIVE_INFINITY;
    }

    /** The range on another scale; an open end stays open. */
    SequentialBar map(DoubleUnaryOperator scale) {
        return new SequentialBar(Double.isInfinite(low) ? low : scale.applyAsDouble(low),
            Double.isInfinite(high) ? high : scale.applyAsDouble(high));
    }

    private static ConstrainedFrequencies likely(ScoreCounts scores) {
        return new ConstrainedFrequencies(scores.values(), scores.frequencies());
    }

    private static SequentialBar range(ScoreCounts scores, double least, double best, double most,
            DoubleFunction<double[]> chances) {
        double z = AnytimeBar.deviations(scores.variance() / scores.observations() / (SLOPE * SLOPE), AnytimeBar.ALPHA);
        DoublePredicate within = value -> ratio(scores, chances.apply(value)) <= z * z / 2;
        return new SequentialBar(within.test(least) ? Double.NEGATIVE_INFINITY : end(within, least, best),
            within.test(most) ? Double.POSITIVE_INFINITY : end(within, most, best));
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
