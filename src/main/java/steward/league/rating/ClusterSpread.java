package steward.league.rating;

import java.util.Arrays;
import java.util.List;

/**
 * Middle matrix B of the sandwich A^-1 B A^-1, the covariance matrix of fitted ratings. B is the covariance of the
 * scores of all clusters, whose sum is zero at the fit (P. J. Huber, "The behavior of maximum likelihood estimates
 * under nonstandard conditions", Berkeley Symposium 5, 1967). It is derived in five steps.
 *
 * <ol>
 * <li>The score u of a cluster is its push on the ratings: for each of its pairs the weight times points - expected
 * points, up for one bot and down for the other. Clusters are independent, so B is the sum of their covariances. Games
 * within a cluster may depend on each other; the square of their sum contains that.</li>
 * <li>The n clusters of a stratum have one distribution. Their covariance is n/(n - 1) times the sum of (u - m)(u -
 * m)', with m their own mean; this is right even if the model is wrong. It has n - 1 degrees of freedom.</li>
 * <li>With fewer than {@link RatingFit#WHOLE} clusters the own mean takes too much of the spread away. There m is the
 * model's. The fit has drawn m towards the clusters by their leverage h, which the factor 1/(1 - h) corrects (CR2:
 * R. M. Bell and D. F. McCaffrey, "Bias reduction in standard errors for linear regression with multi-stage samples",
 * Survey Methodology 28, 2002). It has n(1 - h) degrees of freedom.</li>
 * <li>A few clusters that happen to be alike would seem certain. So the model's covariance is a second estimate, with
 * half a degree of freedom, and both are averaged by their degrees of freedom.</li>
 * <li>If one bot of a pair has fewer than two points, the clusters show hardly any spread. Their variance is raised
 * to the model's variance of points.</li>
 * </ol>
 */
final class ClusterSpread {

    /** Degrees of freedom of the model's covariance in the average. */
    static final double MIXED = 0.5;
    /** Points below which a pair has at least the model's variance. */
    static final double FEW_POINTS = 2;
    private static final double MOST_LEVERAGE = 0.9;
    /** Part of the largest that is left of nothing by rounding. */
    private static final double ROUNDING = 1e-9;

    private final List<Stratum> strata;
    private final double[][] weights;
    private final double[] ratings;
    private final double dispersion;
    private final double[][] inverse;
    /** Covariances by stratum, over its bots' ratings, in rows; {@code null} without clusters. */
    private final double[][] moments;
    private final double[] freedoms;
    /** Strata of two bots: both bots, and the one moment that tells all. Looked up one after another. */
    private final int[] pairs;
    private final double[] singles;
    /** The model's variance of all weighted points, by stratum and pair. */
    private final double[][] variances;

    /**
     * @param weights    of a game, by stratum and pair
     * @param ratings    at the solution, in natural units
     * @param dispersion variance of a game as a share of that of games without ties
     * @param tested     whether these are ratings that are tested: then all clusters count by their distance to the
     *                   model
     * @param inverse    of the second derivatives
     */
    ClusterSpread(List<Stratum> strata, double[][] weights, double[] ratings, double dispersion, boolean tested,
                  double[]... inverse) {
        this.strata = strata;
        this.weights = weights;
        this.ratings = ratings;
        this.dispersion = dispersion;
        this.inverse = inverse;
        moments = new double[strata.size()][];
        freedoms = new double[strata.size()];
        variances = new double[strata.size()][];
        pairs = new int[2 * strata.size()];
        singles = new double[strata.size()];
        for (int q = 0; q < moments.length; q++) {
            if (strata.get(q).clusters > 0) {
                spread(q, !tested && strata.get(q).clusters >= RatingFit.WHOLE);
            }
        }
    }

    /** True if the stratum has at least one cluster; the other methods require it. */
    boolean isAny(int q) {
        return moments[q] != null;
    }

    /** Returns the degrees of freedom of a stratum's part. */
    double freedom(int q) {
        return freedoms[q];
    }

    /** Adds all to a matrix over the ratings. */
    void addTo(double[]... sum) {
        for (int q = 0; q < moments.length; q++) {
            if (isAny(q)) {
                int[] bots = strata.get(q).bots;
                for (int i = 0; i < bots.length; i++) {
                    for (int j = 0; j < bots.length; j++) {
                        sum[bots[i]][bots[j]] += moments[q][i * bots.length + j];
                    }
                }
            }
        }
    }

    /**
     * Returns a stratum's part in the variance of a sum along a direction, which has been multiplied by the inverse.
     */
    double along(int q, double... along) {
        if (pairs[2 * q] != pairs[2 * q + 1]) {
            // The one is pushed up by as much as the other is pushed down.
            double apart = along[pairs[2 * q]] - along[pairs[2 * q + 1]];
            return singles[q] * apart * apart;
        }
        int[] bots = strata.get(q).bots;
        double[] moment = moments[q];
        double sum = 0;
        for (int i = 0; i < bots.length; i++) {
            double row = 0;
            for (int j = 0; j < bots.length; j++) {
                row += moment[i * bots.length + j] * along[bots[j]];
            }
            sum += along[bots[i]] * row;
        }
        return sum;
    }

    /**
     * Returns a stratum's part if games vary as the model says and are independent. All games determine it: a pairing
     * whose few clusters happen to be alike does not seem surer than others.
     */
    double modelled(int q, double... along) {
        double sum = 0;
        for (int k = 0; isAny(q) && k < strata.get(q).pairs(); k++) {
            sum += modelledPair(q, k, along);
        }
        return sum;
    }

    /** Returns one pair's part, likewise. */
    double modelledPair(int q, int k, double... along) {
        Stratum stratum = strata.get(q);
        double apart = along[stratum.bots[stratum.low[k]]] - along[stratum.bots[stratum.high[k]]];
        return variances[q][k] * apart * apart;
    }

    /** True if a stratum's part is that of one of its pairs: the direction has none of its other pairs. */
    boolean isOfOnePair(int q, double... along) {
        Stratum stratum = strata.get(q);
        double most = 0;
        double sum = 0;
        for (int k = 0; k < stratum.pairs(); k++) {
            double apart = Math.abs(along[stratum.bots[stratum.low[k]]] - along[stratum.bots[stratum.high[k]]]);
            most = Math.max(most, apart);
            sum += apart;
        }
        return sum - most <= ROUNDING * most;
    }

    private void spread(int q, boolean own) {
        Stratum stratum = strata.get(q);
        int size = stratum.bots.length;
        double[] mean = new double[stratum.pairs()];
        double[] told = new double[stratum.pairs()];
        double leverage = model(q, mean, told, own);
        double[] moment = observed(q, mean);
        double freedom = own ? stratum.clusters - 1 : stratum.clusters * (1 - leverage);
        double mixed = MIXED / (freedom + MIXED);
        double factor = (own ? stratum.clusters / freedom : 1 / (1 - leverage)) * (1 - mixed);
        for (int k = 0; k < moment.length; k++) {
            moment[k] *= factor;
        }
        double[] lacking = lacking(stratum, weights[q], mean, told);
        for (int k = 0; k < lacking.length; k++) {
            double more = (mixed + lacking[k]) * told[k];
            int i = stratum.low[k];
            int j = stratum.high[k];
            moment[i * size + i] += more;
            moment[j * size + j] += more;
            moment[i * size + j] -= more;
            moment[j * size + i] -= more;
        }
        moments[q] = moment;
        if (size == 2) {
            System.arraycopy(stratum.bots, 0, pairs, 2 * q, 2);
            singles[q] = moment[0];
        }
        variances[q] = told;
        freedoms[q] = freedom + MIXED;
    }

    /**
     * Computes means and variances of a stratum by the model.
     *
     * @param mean to be filled: points of a game, of the model or of the stratum itself
     * @param told to be filled: variance of the points of all weighted games
     * @return the leverage of a cluster
     */
    private double model(int q, double[] mean, double[] told, boolean own) {
        Stratum stratum = strata.get(q);
        double leverage = 0;
        for (int k = 0; k < stratum.pairs(); k++) {
            int one = stratum.bots[stratum.low[k]];
            int other = stratum.bots[stratum.high[k]];
            double points = RatingFit.points(ratings[one] - ratings[other]);
            double games = stratum.sums[3 * k];
            mean[k] = own && games > 0 ? stratum.sums[3 * k + 1] / games : points;
            double weight = weights[q][k];
            told[k] = weight * weight * stratum.weight * games * dispersion * points * (1 - points);
            if (!own) {
                double turn = inverse[one][one] + inverse[other][other] - 2 * inverse[one][other];
                leverage += weight * games * turn * points * (1 - points);
            }
        }
        return Math.min(MOST_LEVERAGE, leverage / stratum.clusters);
    }

    /** Returns the sum over clusters of the squares of their distances to a mean. */
    private double[] observed(int q, double... mean) {
        Stratum stratum = strata.get(q);
        int size = stratum.bots.length;
        double[] moment = new double[size * size];
        double[] push = new double[size];
        for (int p = 0; p < stratum.size; p++) {
            if (stratum.counts[p] == 0) {
                continue;
            }
            Arrays.fill(push, 0);
            double[] numbers = stratum.patterns[p];
            for (int k = 0; k < stratum.pairs(); k++) {
                double surplus = weights[q][k] * (numbers[3 * k + 1] - numbers[3 * k] * mean[k]);
                push[stratum.low[k]] += surplus;
                push[stratum.high[k]] -= surplus;
            }
            for (int i = 0; i < size; i++) {
                double scaled = stratum.counts[p] * push[i];
                for (int j = 0; j < size; j++) {
                    moment[i * size + j] += scaled * push[j];
                }
            }
        }
        return moment;
    }

    /** Returns by pair the share of the model's variance of points that is added; see the last step. */
    private static double[] lacking(Stratum stratum, double[] weights, double[] mean, double... told) {
        double[] lacking = new double[stratum.pairs()];
        for (int k = 0; k < lacking.length; k++) {
            double games = stratum.sums[3 * k];
            double points = stratum.sums[3 * k + 1];
            if (!(told[k] > 0) || Math.min(points, games - points) >= FEW_POINTS) {
                continue;
            }
            double found = 0;
            for (int p = 0; p < stratum.size; p++) {
                double[] numbers = stratum.patterns[p];
                double surplus = weights[k] * (numbers[3 * k + 1] - numbers[3 * k] * mean[k]);
                found += stratum.counts[p] * surplus * surplus;
            }
            lacking[k] = Math.max(0, 1 - found / told[k]);
        }
        return lacking;
    }
}
