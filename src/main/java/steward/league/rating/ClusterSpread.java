package steward.league.rating;

import java.util.Arrays;
import java.util.List;

/**
 * Middle matrix B of the sandwich A^-1 B A^-1, the covariance of a fit at which the scores of all clusters add up to
 * zero (P. J. Huber, "The behavior of maximum likelihood estimates under nonstandard conditions", Berkeley Symposium 5,
 * 1967). It is derived in five steps.
 *
 * <ol>
 * <li>The score u of a cluster, its push on the ratings, is for each of its pairs the weight times points - expected
 * points, up for one bot and down for the other; likewise for the weight of ties. Clusters are independent, so B is the
 * sum of their covariances. Games within a cluster may depend on each other: the square of their sum contains
 * that.</li>
 * <li>The n clusters of a stratum have one distribution. Their covariance is n/(n - 1) times the sum of (u - m)(u -
 * m)', m their own mean; this is right even where the model is wrong. It has n - 1 degrees of freedom.</li>
 * <li>With fewer than {@link RatingFit#WHOLE} clusters the own mean takes too much of the spread away. There m is the
 * model's. The fit has drawn that towards the clusters by their leverage h, which the factor 1/(1 - h) corrects (CR2:
 * R. M. Bell and D. F. McCaffrey, "Bias reduction in standard errors for linear regression with multi-stage samples",
 * Survey Methodology 28, 2002). It has n(1 - h) degrees of freedom.</li>
 * <li>A few clusters that happen to be alike would seem certain. So the model's covariance is a second estimate, with
 * half a degree of freedom, and both are averaged by their degrees of freedom.</li>
 * <li>Where one bot of a pair has fewer than two points, the clusters show hardly any spread. Their variance is raised
 * to the model's variance of points.</li>
 * </ol>
 */
final class ClusterSpread {

    /** Degrees of freedom of the model's covariance in the average. */
    static final double MIXED = 0.5;
    /** Points below which a pair has at least the model's variance. */
    static final double FEW_POINTS = 2;
    private static final double MOST_LEVERAGE = 0.9;

    private final List<Stratum> strata;
    private final double[][] weights;
    private final double[] ratings;
    private final boolean tied;
    private final double ties;
    private final double[][] inverse;
    /**
     * Covariances by stratum, over its bots' ratings and the weight of ties, in rows; {@code null} without clusters.
     */
    private final double[][] moments;
    private final double[] freedoms;
    /** Strata of two bots: both bots, and the three moments that differ. Looked up one after another. */
    private final int[] pairs;
    private final double[] threes;
    /** The model's variance of points, covariance and variance of ties, by stratum and pair, all weighted. */
    private final double[][] variances;

    /**
     * @param weights of a game, by stratum and pair
     * @param ratings at the maximum, in natural units
     * @param tied    whether there are ties: then the inverse has a last row for the logarithm of their weight
     * @param ties    the weight of ties
     * @param tested  whether these are ratings that are tested: then all clusters count by their distance to the model
     * @param inverse of the second derivatives
     */
    ClusterSpread(List<Stratum> strata, double[][] weights, double[] ratings, boolean tied, double ties, boolean tested,
                  double[]... inverse) {
        this.strata = strata;
        this.weights = weights;
        this.ratings = ratings;
        this.tied = tied;
        this.ties = ties;
        this.inverse = inverse;
        moments = new double[strata.size()][];
        freedoms = new double[strata.size()];
        variances = new double[strata.size()][];
        pairs = new int[2 * strata.size()];
        threes = new double[3 * strata.size()];
        TieModel model = new TieModel();
        for (int q = 0; q < moments.length; q++) {
            if (strata.get(q).clusters > 0) {
                spread(q, model, !tested && strata.get(q).clusters >= RatingFit.WHOLE);
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

    /** Adds all to a matrix over the ratings and, where there are ties, the logarithm of their weight. */
    void addTo(double[]... sum) {
        for (int q = 0; q < moments.length; q++) {
            if (isAny(q)) {
                int[] bots = strata.get(q).bots;
                int size = bots.length + 1;
                int used = tied ? size : bots.length;
                for (int i = 0; i < used; i++) {
                    double[] row = sum[i < bots.length ? bots[i] : sum.length - 1];
                    for (int j = 0; j < used; j++) {
                        row[j < bots.length ? bots[j] : sum.length - 1] += moments[q][i * size + j];
                    }
                }
            }
        }
    }

    /**
     * Returns a stratum's part in the variance of a sum along a direction, which has been multiplied by the inverse.
     */
    double along(int q, double... along) {
        double last = tied ? along[along.length - 1] : 0;
        if (pairs[2 * q] != pairs[2 * q + 1]) {
            // The one is pushed up by as much as the other is pushed down: of the 9 moments 3 differ.
            double apart = along[pairs[2 * q]] - along[pairs[2 * q + 1]];
            return threes[3 * q] * apart * apart + 2 * threes[3 * q + 1] * apart * last
                + threes[3 * q + 2] * last * last;
        }
        int[] bots = strata.get(q).bots;
        int size = bots.length + 1;
        double[] moment = moments[q];
        double sum = 0;
        for (int i = 0; i < size; i++) {
            double own = i < bots.length ? along[bots[i]] : last;
            double row = 0;
            for (int j = 0; j < size; j++) {
                row += moment[i * size + j] * (j < bots.length ? along[bots[j]] : last);
            }
            sum += own * row;
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
        double[] told = variances[q];
        double last = tied ? along[along.length - 1] : 0;
        double apart = along[stratum.bots[stratum.low[k]]] - along[stratum.bots[stratum.high[k]]];
        return told[3 * k] * apart * apart + 2 * told[3 * k + 1] * apart * last + told[3 * k + 2] * last * last;
    }

    private void spread(int q, TieModel model, boolean own) {
        Stratum stratum = strata.get(q);
        int size = stratum.bots.length + 1;
        double[] mean = new double[2 * stratum.pairs()];
        double[] told = new double[3 * stratum.pairs()];
        double leverage = model(q, model, mean, told, own);
        double[] moment = observed(q, mean);
        double freedom = own ? stratum.clusters - 1 : stratum.clusters * (1 - leverage);
        double mixed = MIXED / (freedom + MIXED);
        double factor = (own ? stratum.clusters / freedom : 1 / (1 - leverage)) * (1 - mixed);
        for (int k = 0; k < moment.length; k++) {
            moment[k] *= factor;
        }
        double[] lacking = lacking(stratum, weights[q], mean, told);
        for (int k = 0; k < lacking.length; k++) {
            addPair(moment, size, stratum.low[k], stratum.high[k], (mixed + lacking[k]) * told[3 * k],
                mixed * told[3 * k + 1], mixed * told[3 * k + 2]);
        }
        moments[q] = moment;
        if (stratum.bots.length == 2) {
            System.arraycopy(stratum.bots, 0, pairs, 2 * q, 2);
            threes[3 * q] = moment[0];
            threes[3 * q + 1] = moment[2];
            threes[3 * q + 2] = moment[moment.length - 1];
        }
        variances[q] = told;
        freedoms[q] = freedom + MIXED;
    }

    private static void addPair(double[] moment, int size, int i, int j, double points, double covariance, double tie) {
        int last = size - 1;
        moment[i * size + i] += points;
        moment[j * size + j] += points;
        moment[i * size + j] -= points;
        moment[j * size + i] -= points;
        moment[i * size + last] += covariance;
        moment[last * size + i] += covariance;
        moment[j * size + last] -= covariance;
        moment[last * size + j] -= covariance;
        moment[last * size + last] += tie;
    }

    /**
     * Computes means and variances of a stratum by the model.
     *
     * @param mean      to be filled: points and ties of a game, of the model or of the stratum itself
     * @param told      to be filled: variance of the points, covariance, variance of ties of all weighted games
     * @return the leverage of a cluster
     */
    private double model(int q, TieModel model, double[] mean, double[] told, boolean own) {
        Stratum stratum = strata.get(q);
        int last = inverse.length - 1;
        double leverage = 0;
        for (int k = 0; k < stratum.pairs(); k++) {
            int one = stratum.bots[stratum.low[k]];
            int other = stratum.bots[stratum.high[k]];
            model.compute(ratings[one] - ratings[other], ties);
            double games = stratum.sums[3 * k];
            mean[2 * k] = own && games > 0 ? stratum.sums[3 * k + 1] / games : model.points;
            mean[2 * k + 1] = own && games > 0 ? stratum.sums[3 * k + 2] / games : model.tie;
            double weight = weights[q][k];
            double square = weight * weight * stratum.weight * games;
            told[3 * k] = square * model.pointsVariance;
            told[3 * k + 1] = tied ? square * model.covariance : 0;
            told[3 * k + 2] = tied ? square * model.tieVariance : 0;
            if (!own) {
                double turn = inverse[one][one] + inverse[other][other] - 2 * inverse[one][other];
                double part = turn * model.pointsVariance;
                if (tied) {
                    part += 2 * (inverse[one][last] - inverse[other][last]) * model.covariance
                        + inverse[last][last] * model.tieVariance;
                }
                leverage += weight * games * part;
            }
        }
        return Math.min(MOST_LEVERAGE, leverage / stratum.clusters);
    }

    /** Returns the sum over clusters of the squares of their distances to a mean. */
    private double[] observed(int q, double... mean) {
        Stratum stratum = strata.get(q);
        int last = stratum.bots.length;
        int size = last + 1;
        double[] moment = new double[size * size];
        double[] push = new double[size];
        for (int p = 0; p < stratum.size; p++) {
            if (stratum.counts[p] == 0) {
                continue;
            }
            Arrays.fill(push, 0);
            double[] numbers = stratum.patterns[p];
            for (int k = 0; k < stratum.pairs(); k++) {
                double weight = weights[q][k];
                double surplus = weight * (numbers[3 * k + 1] - numbers[3 * k] * mean[2 * k]);
                push[stratum.low[k]] += surplus;
                push[stratum.high[k]] -= surplus;
                push[last] += tied ? weight * (numbers[3 * k + 2] - numbers[3 * k] * mean[2 * k + 1]) : 0;
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
            if (!(games > 0) || Math.min(points, games - points) >= FEW_POINTS) {
                continue;
            }
            double found = 0;
            for (int p = 0; p < stratum.size; p++) {
                double[] numbers = stratum.patterns[p];
                double surplus = weights[k] * (numbers[3 * k + 1] - numbers[3 * k] * mean[2 * k]);
                found += stratum.counts[p] * surplus * surplus;
            }
            lacking[k] = Math.max(0, 1 - found / told[3 * k]);
        }
        return lacking;
    }
}
