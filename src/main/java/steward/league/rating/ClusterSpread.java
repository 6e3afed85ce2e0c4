package steward.league.rating;

import java.util.Arrays;
import java.util.List;

/**
 * The B of the sandwich A^-1 B A^-1: by stratum the covariance of what its clusters push at the maximum of a fit.
 *
 * <p>A cluster counts by its distance to its own pairing's mean, which is right also where the model is wrong, with the
 * factor n/(n - 1); where the pairing has fewer than {@link RatingFit#WHOLE} clusters by its distance to the model with
 * the correction 1/(1 - h), h its leverage (CR2: R. M. Bell and D. F. McCaffrey, "Bias reduction in standard errors for
 * linear regression with multi-stage samples", Survey Methodology 28, 2002). Half a cluster of the model's variance is
 * mixed in, so that a few alike clusters do not seem certain.
 */
final class ClusterSpread {

    /** In clusters: how much of the model's variance is mixed into that of a pairing. */
    static final double MIXED = 0.5;
    /** A pair of whom one has fewer points than this has at least the model's variance: there is too little to see. */
    static final double FEW_POINTS = 2;
    private static final double MOST_LEVERAGE = 0.9;

    private final List<Stratum> strata;
    private final double[][] weights;
    private final double[] ratings;
    private final boolean tied;
    private final double ties;
    private final double[][] inverse;
    /** By stratum, over its bots' ratings and the weight of ties, in rows; {@code null} without clusters. */
    private final double[][] moments;
    private final double[] freedoms;

    /**
     * @param weights of a game, by stratum and pair
     * @param ratings at the maximum, in natural units
     * @param tied    whether there are ties: then the inverse has a last row for the logarithm of their weight
     * @param ties    the weight of ties
     * @param inverse of the second derivatives
     */
    ClusterSpread(List<Stratum> strata, double[][] weights, double[] ratings, boolean tied, double ties,
                  double[]... inverse) {
        this.strata = strata;
        this.weights = weights;
        this.ratings = ratings;
        this.tied = tied;
        this.ties = ties;
        this.inverse = inverse;
        moments = new double[strata.size()][];
        freedoms = new double[strata.size()];
        TieModel model = new TieModel();
        for (int q = 0; q < moments.length; q++) {
            if (strata.get(q).clusters > 0) {
                spread(q, model);
            }
        }
    }

    /** Whether a stratum has clusters; of others there is nothing to ask. */
    boolean isAny(int q) {
        return moments[q] != null;
    }

    /** Degrees of freedom of a stratum's part. */
    double freedom(int q) {
        return freedoms[q];
    }

    /** A stratum's part in the variance of a sum along a direction, which has been multiplied by the inverse. */
    double along(int q, double... along) {
        int[] group = strata.get(q).bots;
        int size = group.length + 1;
        double[] moment = moments[q];
        double last = tied ? along[along.length - 1] : 0;
        if (group.length == 2) {
            // What one is pushed up the other is pushed down: of the 9 moments 3 differ.
            double apart = along[group[0]] - along[group[1]];
            return moment[0] * apart * apart + 2 * moment[2] * apart * last + moment[8] * last * last;
        }
        double sum = 0;
        for (int i = 0; i < size; i++) {
            double own = i < group.length ? along[group[i]] : last;
            double row = 0;
            for (int j = 0; j < size; j++) {
                row += moment[i * size + j] * (j < group.length ? along[group[j]] : last);
            }
            sum += own * row;
        }
        return sum;
    }

    private void spread(int q, TieModel model) {
        Stratum stratum = strata.get(q);
        int pairs = stratum.pairs();
        int size = stratum.bots.length + 1;
        double[] mean = new double[2 * pairs];
        double[] variances = new double[3 * pairs];
        boolean own = stratum.clusters >= RatingFit.WHOLE;
        double leverage = model(q, model, mean, variances, own);
        double[] found = observed(q, mean);
        double freedom = own ? stratum.clusters - 1 : stratum.clusters * (1 - leverage);
        double factor = (own ? stratum.clusters / freedom : 1 / (1 - leverage)) * freedom / (freedom + MIXED);
        double[] extra = extremes(stratum, weights[q], mean, variances);
        double[] moment = new double[size * size];
        for (int k = 0; k < moment.length; k++) {
            moment[k] = factor * found[k];
        }
        int pair = 0;
        for (int i = 0; i + 1 < size; i++) {
            for (int j = i + 1; j + 1 < size; j++) {
                double mixed = MIXED / (freedom + MIXED);
                addPair(moment, size, i, j, (mixed + extra[pair]) * variances[3 * pair],
                    mixed * variances[3 * pair + 1], mixed * variances[3 * pair + 2]);
                pair++;
            }
        }
        moments[q] = moment;
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
     * What the model says of a stratum.
     *
     * @param mean      to be filled: points and ties of a game, of the model or of the stratum itself
     * @param variances to be filled: variance of the points, covariance, variance of ties of all weighted games
     * @return the leverage of a cluster
     */
    private double model(int q, TieModel model, double[] mean, double[] variances, boolean own) {
        Stratum stratum = strata.get(q);
        int last = inverse.length - 1;
        double leverage = 0;
        int pair = 0;
        for (int i = 0; i < stratum.bots.length; i++) {
            for (int j = i + 1; j < stratum.bots.length; j++) {
                int one = stratum.bots[i];
                int other = stratum.bots[j];
                model.compute(ratings[one] - ratings[other], ties);
                double games = stratum.sums[3 * pair];
                mean[2 * pair] = own && games > 0 ? stratum.sums[3 * pair + 1] / games : model.points;
                mean[2 * pair + 1] = own && games > 0 ? stratum.sums[3 * pair + 2] / games : model.tie;
                double weight = weights[q][pair];
                double square = weight * weight * stratum.weight * games;
                variances[3 * pair] = square * model.pointsVariance;
                variances[3 * pair + 1] = tied ? square * model.covariance : 0;
                variances[3 * pair + 2] = tied ? square * model.tieVariance : 0;
                if (!own) {
                    double turn = inverse[one][one] + inverse[other][other] - 2 * inverse[one][other];
                    double part = turn * model.pointsVariance;
                    if (tied) {
                        part += 2 * (inverse[one][last] - inverse[other][last]) * model.covariance
                            + inverse[last][last] * model.tieVariance;
                    }
                    leverage += weight * games * part;
                }
                pair++;
            }
        }
        return Math.min(MOST_LEVERAGE, leverage / stratum.clusters);
    }

    /** The sum over clusters of the squares of their distances to a mean. */
    private double[] observed(int q, double... mean) {
        Stratum stratum = strata.get(q);
        int group = stratum.bots.length;
        int size = group + 1;
        double[] moment = new double[size * size];
        double[] push = new double[size];
        for (int p = 0; p < stratum.size; p++) {
            if (stratum.counts[p] == 0) {
                continue;
            }
            Arrays.fill(push, 0);
            double[] numbers = stratum.patterns[p];
            int pair = 0;
            for (int i = 0; i < group; i++) {
                for (int j = i + 1; j < group; j++) {
                    double weight = weights[q][pair];
                    double surplus = weight * (numbers[3 * pair + 1] - numbers[3 * pair] * mean[2 * pair]);
                    push[i] += surplus;
                    push[j] -= surplus;
                    push[group] += tied
                        ? weight * (numbers[3 * pair + 2] - numbers[3 * pair] * mean[2 * pair + 1]) : 0;
                    pair++;
                }
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

    /** By pair, which part of the model's variance is added: where one has hardly any points what is missing to it. */
    private static double[] extremes(Stratum stratum, double[] weights, double[] mean, double... variances) {
        double[] extra = new double[stratum.pairs()];
        for (int pair = 0; pair < extra.length; pair++) {
            double games = stratum.sums[3 * pair];
            double points = stratum.sums[3 * pair + 1];
            if (!(games > 0) || Math.min(points, games - points) >= FEW_POINTS) {
                continue;
            }
            double found = 0;
            for (int p = 0; p < stratum.size; p++) {
                double[] numbers = stratum.patterns[p];
                double surplus = weights[pair] * (numbers[3 * pair + 1] - numbers[3 * pair] * mean[2 * pair]);
                found += stratum.counts[p] * surplus * surplus;
            }
            extra[pair] = Math.max(0, 1 - found / variances[3 * pair]);
        }
        return extra;
    }
}
