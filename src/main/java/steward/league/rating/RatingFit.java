package steward.league.rating;

import java.util.Arrays;
import java.util.List;

/**
 * Ratings from all clusters together: the maximum of the posterior of {@link TieModel} with a weak normal prior, each
 * pairing with the same weight however often it was played, and a covariance from the spread of the clusters.
 * docs/rating.md has the formulas.
 *
 * <p><b>Weights.</b> Where results are not transitive no rating tells all of them, and a fit that weighs games depends
 * on who was paired how often. Here a pairing's games weigh what they would if all were played equally often: ratings
 * estimate the fit under uniform pairing. A pairing with n clusters, fewer than {@link #WHOLE},
 * has the n/8th part of a weight. In games of three and more the group is what is paired.
 *
 * <p><b>Covariance.</b> That of an M-estimate over clusters, the sandwich A^-1 B A^-1. In B a cluster counts
 * by its distance to its own pairing's mean, which is right also where the model is wrong, with the factor n/(n - 1);
 * where the pairing has fewer than {@link #WHOLE} clusters by its distance to the model with the correction 1/(1 - h),
 * h its leverage (CR2: R. M. Bell and D. F. McCaffrey, "Bias reduction in standard errors for linear regression with
 * multi-stage samples", Survey Methodology 28, 2002). Half a cluster of the model's variance is mixed in, so that a few
 * alike clusters do not seem certain. Degrees of freedom after Satterthwaite (Biometrics Bulletin 2, 1946).
 */
public final class RatingFit {

    /** Elo points for a factor of e in the odds: 400 / ln 10. */
    public static final double ELO = 173.7177927613007;
    /** Clusters from which a pairing has its whole weight, and its own mean. */
    static final int WHOLE = 8;
    /** The prior's standard deviation, in Elo: strengths of 95% of all bots within about 3000. */
    static final double PRIOR_ELO = 750;
    static final double PRIOR = ELO * ELO / (PRIOR_ELO * PRIOR_ELO);
    /** Of the logarithm of the weight of ties, whose standard deviation is 3: a factor of 20. */
    static final double TIES_PRIOR = 1.0 / 9;
    private static final int MOST_STEPS = 100;
    /** A longer step is shortened: far from the top the parabola is a poor guide. */
    private static final double LONGEST_STEP = 2;
    private static final double CLOSE = 1e-10;
    /** In clusters: how much of the model's variance is mixed into that of a pairing. */
    private static final double MIXED = 0.5;
    private static final double MOST_LEVERAGE = 0.9;
    /** Degrees of freedom of a variance that is known. */
    private static final double CERTAIN = 1e9;
    /** A pair of whom one has fewer points than this has at least the model's variance: there is too little to see. */
    private static final double FEW_POINTS = 2;

    private final int bots;
    private final List<Stratum> strata;
    /** The weight of a game of each pair of each stratum. */
    private final double[][] weights;
    private final double[] ratings;
    private boolean tied;
    private double logTies;
    private double[][] inverse;
    private double[][] moments;
    private double[] freedoms;

    private RatingFit(int bots, List<Stratum> strata, boolean pooled) {
        this.bots = bots;
        this.strata = strata;
        ratings = new double[bots];
        weights = PairingWeights.of(bots, strata, pooled);
    }

    /**
     * Fits.
     *
     * @param bots   how many
     * @param strata whose bots are 0..bots - 1
     * @param pooled whether what is paired are two bots, in whatever company: where each plays alone on the same map
     */
    public static RatingFit of(int bots, List<Stratum> strata, boolean pooled) {
        return of(bots, strata, pooled, null);
    }

    /** The same, begun at another fit of the same bots, which is quicker where that is close; or {@code null}. */
    public static RatingFit of(int bots, List<Stratum> strata, boolean pooled, RatingFit near) {
        RatingFit fit = new RatingFit(bots, strata, pooled);
        fit.climb(near);
        fit.spread();
        return fit;
    }

    // ---- the maximum -----------------------------------------------------------------------------

    /** Newton's method: the logarithm of the posterior is concave. */
    private void climb(RatingFit near) {
        double[][] sums = new double[3][bots * bots];
        Stratum.each(strata, (q, k, low, high) -> {
            double[] own = strata.get(q).sums;
            for (int what = 0; what < 3; what++) {
                sums[what][low * bots + high] += weights[q][k] * own[3 * k + what];
            }
        });
        double ties = 0;
        for (double each : sums[2]) {
            ties += each;
        }
        tied = ties > 0;
        if (near != null) {
            System.arraycopy(near.ratings, 0, ratings, 0, bots);
            logTies = near.logTies;
        }
        int size = bots + (tied ? 1 : 0);
        double[] slope = new double[size];
        double[][] curvature = new double[size][size];
        TieModel model = new TieModel();
        Cholesky factor = null;
        for (int step = 0; step < MOST_STEPS; step++) {
            derivatives(sums, model, slope, curvature);
            factor = new Cholesky(curvature);
            double[] change = factor.solve(slope);
            double longest = 0;
            for (double each : change) {
                longest = Math.max(longest, Math.abs(each));
            }
            double part = longest > LONGEST_STEP ? LONGEST_STEP / longest : 1;
            for (int i = 0; i < bots; i++) {
                ratings[i] += part * change[i];
            }
            logTies += tied ? part * change[bots] : 0;
            if (longest < CLOSE) {
                break;
            }
        }
        inverse = factor.inverse();
    }

    private void derivatives(double[][] sums, TieModel model, double[] slope, double[][] curvature) {
        for (int i = 0; i < slope.length; i++) {
            Arrays.fill(curvature[i], 0);
            slope[i] = i == bots ? -TIES_PRIOR * logTies : -PRIOR * ratings[i];
            curvature[i][i] = i == bots ? TIES_PRIOR : PRIOR;
        }
        double ties = ties();
        for (int i = 0; i < bots; i++) {
            for (int j = i + 1; j < bots; j++) {
                double games = sums[0][i * bots + j];
                if (!(games > 0)) {
                    continue;
                }
                model.compute(ratings[i] - ratings[j], ties);
                double surplus = sums[1][i * bots + j] - games * model.points;
                double weight = games * model.pointsVariance;
                slope[i] += surplus;
                slope[j] -= surplus;
                curvature[i][i] += weight;
                curvature[j][j] += weight;
                curvature[i][j] -= weight;
                curvature[j][i] -= weight;
                if (tied) {
                    slope[bots] += sums[2][i * bots + j] - games * model.tie;
                    curvature[bots][bots] += games * model.tieVariance;
                    double mixed = games * model.covariance;
                    curvature[bots][i] += mixed;
                    curvature[i][bots] += mixed;
                    curvature[bots][j] -= mixed;
                    curvature[j][bots] -= mixed;
                }
            }
        }
    }

    private double ties() {
        return tied ? StrictMath.exp(logTies) : 0;
    }

    // ---- the spread of clusters ------------------------------------------------------------------

    /** For each stratum the covariance of what its clusters push: its bots' ratings, and the weight of ties. */
    private void spread() {
        moments = new double[strata.size()][];
        freedoms = new double[strata.size()];
        TieModel model = new TieModel();
        for (int q = 0; q < moments.length; q++) {
            if (strata.get(q).clusters > 0) {
                spread(q, model);
            }
        }
    }

    private void spread(int q, TieModel model) {
        Stratum stratum = strata.get(q);
        int pairs = stratum.pairs();
        int size = stratum.bots.length + 1;
        double[] mean = new double[2 * pairs];
        double[] variances = new double[3 * pairs];
        boolean own = stratum.clusters >= WHOLE;
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
        double leverage = 0;
        int pair = 0;
        for (int i = 0; i < stratum.bots.length; i++) {
            for (int j = i + 1; j < stratum.bots.length; j++) {
                int one = stratum.bots[i];
                int other = stratum.bots[j];
                model.compute(ratings[one] - ratings[other], ties());
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
                        part += 2 * (inverse[one][bots] - inverse[other][bots]) * model.covariance
                            + inverse[bots][bots] * model.tieVariance;
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

    // ---- what can be asked -----------------------------------------------------------------------

    /** How many bots there are. */
    public int bots() {
        return bots;
    }

    /** In Elo, from the prior's middle. */
    public double rating(int bot) {
        return ELO * ratings[bot];
    }

    /** The weight of ties in {@link TieModel}; 0 where there are none. */
    public double tieWeight() {
        return ties();
    }

    /** Expected points of one bot in a game against another. */
    public double expected(int one, int other) {
        TieModel model = new TieModel();
        model.compute(ratings[one] - ratings[other], ties());
        return model.points;
    }

    /** What the games between two bots say beside their ratings. */
    public Residual residual(int one, int other) {
        double[] sums = new double[2];
        long[] clusters = new long[1];
        Stratum.each(strata, (q, k, low, high) -> {
            if (low == Math.min(one, other) && high == Math.max(one, other)) {
                double[] own = strata.get(q).sums;
                sums[0] += own[3 * k];
                sums[1] += low == one ? own[3 * k + 1] : own[3 * k] - own[3 * k + 1];
                clusters[0] += strata.get(q).clusters;
            }
        });
        double share = sums[1] / sums[0];
        double expected = expected(one, other);
        if (clusters[0] < WHOLE) {
            return new Residual(share, expected, clusters[0], 0);
        }
        double[] squares = new double[1];
        Stratum.each(strata, (q, k, low, high) -> {
            if (low == Math.min(one, other) && high == Math.max(one, other)) {
                Stratum stratum = strata.get(q);
                for (int p = 0; p < stratum.size; p++) {
                    double games = stratum.patterns[p][3 * k];
                    double points = stratum.patterns[p][3 * k + 1];
                    double surplus = (low == one ? points : games - points) - games * share;
                    squares[0] += stratum.counts[p] * surplus * surplus;
                }
            }
        });
        double freedom = clusters[0] - 1;
        // As in the fit, a part of what the model says: clusters that are all alike are not certain.
        double alike = share * (1 - share) / 2 + expected * (1 - expected) / 2;
        double variance = (squares[0] * clusters[0] / freedom + MIXED * sums[0] * alike / clusters[0])
            / (sums[0] * sums[0]);
        if (Math.min(sums[1], sums[0] - sums[1]) < FEW_POINTS) {
            variance = Math.max(variance, expected * (1 - expected) / sums[0]);
        }
        return new Residual(share, expected, clusters[0],
            Normal.ofStudent((share - expected) / Math.sqrt(variance), freedom));
    }

    /** The difference of two ratings. */
    public Difference difference(int one, int other) {
        double[] along = new double[inverse.length];
        for (int k = 0; k < along.length; k++) {
            along[k] = inverse[one][k] - inverse[other][k];
        }
        return of(along, ratings[one] - ratings[other]);
    }

    /** Takes the part of a group of bots. */
    interface PartTaker {
        void take(int[] group, double part);
    }

    /** Tells by group: its number of clusters times their part in the variance of a difference, as a share of it. */
    void parts(int one, int other, PartTaker taker) {
        double[] along = new double[inverse.length];
        for (int k = 0; k < along.length; k++) {
            along[k] = inverse[one][k] - inverse[other][k];
        }
        double variance = of(along, 0).variance();
        for (int q = 0; q < moments.length; q++) {
            if (moments[q] != null) {
                taker.take(strata.get(q).bots, along(q, along) * strata.get(q).clusters / variance);
            }
        }
    }

    /** The difference of a rating to the weighted mean of all; the weights have the sum 1. */
    public Difference toMean(int bot, double... mean) {
        double[] along = inverse[bot].clone();
        double value = ratings[bot];
        for (int i = 0; i < bots; i++) {
            for (int k = 0; k < along.length; k++) {
                along[k] -= mean[i] * inverse[i][k];
            }
            value -= mean[i] * ratings[i];
        }
        return of(along, value);
    }

    /** The variance of a sum along a direction, which has been multiplied by the inverse. */
    private Difference of(double[] along, double value) {
        double variance = 0;
        for (int i = 0; i < bots; i++) {
            variance += PRIOR * along[i] * along[i];
        }
        variance += tied ? TIES_PRIOR * along[bots] * along[bots] : 0;
        double squares = 0;
        for (int q = 0; q < moments.length; q++) {
            if (moments[q] != null) {
                double part = along(q, along);
                variance += part;
                squares += part * part / freedoms[q];
            }
        }
        return new Difference(value, variance,
            squares > 0 ? Math.min(CERTAIN, variance * variance / squares) : CERTAIN);
    }

    private double along(int q, double... along) {
        int[] group = strata.get(q).bots;
        int size = group.length + 1;
        double[] moment = moments[q];
        double last = tied ? along[bots] : 0;
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
}
