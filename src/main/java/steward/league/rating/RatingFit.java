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
 * <p><b>Covariance.</b> That of an M-estimate over clusters, the sandwich A^-1 B A^-1; {@link ClusterSpread} is B.
 * Degrees of freedom after Satterthwaite (Biometrics Bulletin 2, 1946).
 */
public final class RatingFit {

    /** Elo points for a factor of e in the odds: 400 / ln 10. */
    public static final double ELO = 173.7177927613007;
    /** Clusters from which a pairing has its whole weight, and its own mean. */
    static final int WHOLE = 8;
    /** The prior's standard deviation, in Elo: strengths of 95% of all bots within about 3000. */
    static final double PRIOR_ELO = 750;
    static final double PRIOR = ELO * ELO / (PRIOR_ELO * PRIOR_ELO);
    /** Prior of the logarithm of the weight of ties, whose standard deviation is 3: a factor of 20. */
    static final double TIES_PRIOR = 1.0 / 9;
    private static final int MOST_STEPS = 100;
    /** A longer step is shortened: far from the top the parabola is a poor guide. */
    private static final double LONGEST_STEP = 2;
    private static final double CLOSE = 1e-10;
    /** Pull between two ratings that are held together, as a multiple of the games'. */
    private static final double HELD = 10_000;
    /** Degrees of freedom of a variance that is known. */
    static final double CERTAIN = 1e9;

    private final int bots;
    private final List<Stratum> strata;
    /** The weight of a game of each pair of each stratum. */
    final double[][] weights;
    private final double[] ratings;
    /** Weighted points and games of each bot. */
    private final double[] points;
    private final double[] games;
    private boolean tied;
    private double logTies;
    private double[][] inverse;
    private ClusterSpread spread;
    private Covariance covariance;
    private Residuals residuals;
    /** The weighted mean that was asked for last, and its direction, multiplied by the inverse. */
    private double[] meanWeights;
    private double[] meanAlong;
    private double meanValue;

    private RatingFit(int bots, List<Stratum> strata, double[]... weights) {
        this.bots = bots;
        this.strata = strata;
        ratings = new double[bots];
        points = new double[bots];
        games = new double[bots];
        this.weights = weights;
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

    /** Fits, beginning at another fit of these bots, which is quicker where that is close; or {@code null}. */
    public static RatingFit of(int bots, List<Stratum> strata, boolean pooled, RatingFit near) {
        RatingFit fit = new RatingFit(bots, strata, PairingWeights.of(strata, pooled));
        fit.climb(near, null);
        fit.spread = new ClusterSpread(strata, fit.weights, fit.ratings, fit.tied, fit.ties(), false, fit.inverse);
        return fit;
    }

    // ---- the maximum -----------------------------------------------------------------------------

    /**
     * Newton's method: the logarithm of the posterior is concave.
     *
     * @param held what is held, or {@code null}
     * @return the step that would come next; with something that is held, if it were let go
     */
    private double[] climb(RatingFit near, Held held) {
        double[][] sums = new double[3][bots * bots];
        Stratum.each(strata, (q, k, low, high) -> {
            double[] own = strata.get(q).sums;
            for (int what = 0; what < 3; what++) {
                sums[what][low * bots + high] += weights[q][k] * own[3 * k + what];
            }
        });
        double ties = 0;
        for (int k = 0; k < sums[2].length; k++) {
            ties += sums[2][k];
            games[k / bots] += sums[0][k];
            games[k % bots] += sums[0][k];
            points[k / bots] += sums[1][k];
            points[k % bots] += sums[0][k] - sums[1][k];
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
            if (held != null) {
                hold(slope, curvature, held);
            }
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
        if (held != null) {
            derivatives(sums, model, slope, curvature);
            factor = new Cholesky(curvature);
        }
        inverse = factor.inverse();
        return factor.solve(slope);
    }

    /**
     * A sum of ratings that is held at a value.
     *
     * @param contrast by bot, what the sum has of its rating; together 0
     * @param value    in natural units
     */
    private record Held(double[] contrast, double value) { }

    /**
     * The best fit in which a sum of ratings has a value.
     *
     * @param fit  its covariance is that of the step
     * @param step that would come next if the sum was let go; in natural units
     */
    record HeldFit(RatingFit fit, double... step) { }

    /**
     * Fits with a sum of ratings held.
     *
     * @param contrast by bot, what the sum has of its rating; together 0
     */
    HeldFit held(double[] contrast, double value) {
        RatingFit fit = new RatingFit(bots, strata, weights);
        double[] step = fit.climb(this, new Held(contrast, value));
        fit.spread = new ClusterSpread(strata, weights, fit.ratings, fit.tied, fit.ties(), true, fit.inverse);
        return new HeldFit(fit, step);
    }

    private void hold(double[] slope, double[][] curvature, Held held) {
        double[] contrast = held.contrast();
        double pull = 0;
        double apart = -held.value();
        for (int i = 0; i < bots; i++) {
            pull += HELD * contrast[i] * contrast[i] * curvature[i][i];
            apart += contrast[i] * ratings[i];
        }
        for (int i = 0; i < bots; i++) {
            slope[i] -= pull * apart * contrast[i];
            for (int j = 0; j < bots; j++) {
                curvature[i][j] += pull * contrast[i] * contrast[j];
            }
        }
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

    // ---- what can be asked -----------------------------------------------------------------------

    List<Stratum> strata() {
        return strata;
    }

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

    /** Residuals of all pairs, from where they are asked for the first time. */
    Residuals residuals() {
        if (residuals == null) {
            residuals = new Residuals(this);
        }
        return residuals;
    }

    public Difference difference(int one, int other) {
        return of(along(one, other), ratings[one] - ratings[other]);
    }

    /** Share of the weighted points of a bot; NaN without games. */
    double share(int bot) {
        return points[bot] / games[bot];
    }

    /** Weighted games of a bot. */
    double games(int bot) {
        return games[bot];
    }

    /** In natural units. */
    double value(int bot) {
        return ratings[bot];
    }

    /** Variances of all differences, from where they are asked for the first time. */
    Covariance covariance() {
        if (covariance == null) {
            covariance = new Covariance(this);
        }
        return covariance;
    }

    ClusterSpread spread() {
        return spread;
    }

    /** By rating and, where there are ties, the logarithm of their weight: what the prior pushes by chance. */
    double[] priors() {
        double[] priors = new double[inverse.length];
        Arrays.fill(priors, 0, bots, PRIOR);
        Arrays.fill(priors, bots, priors.length, TIES_PRIOR);
        return priors;
    }

    double[][] inverse() {
        return inverse;
    }

    /**
     * Adds by stratum and group: its number of clusters times its part in the variance of a difference, as a share of
     * it. That is what one cluster more takes away, times the square of the number. Variances are those that the model
     * tells.
     */
    void addParts(int one, int other, double[]... parts) {
        double[] along = along(one, other);
        double variance = 0;
        double[][] own = new double[parts.length][];
        for (int q = 0; q < parts.length; q++) {
            own[q] = new double[parts[q].length];
            for (int k = 0; spread.isAny(q) && k < strata.get(q).pairs(); k++) {
                double part = spread.modelledPair(q, k, along);
                own[q][strata.get(q).group[k]] += part;
                variance += part;
            }
        }
        for (int q = 0; q < parts.length; q++) {
            for (int group = 0; group < own[q].length; group++) {
                parts[q][group] += variance > 0 ? own[q][group] * strata.get(q).clusters / variance : 0;
            }
        }
    }

    /** The direction of a difference, multiplied by the inverse. */
    double[] along(int one, int other) {
        double[] along = new double[inverse.length];
        for (int k = 0; k < along.length; k++) {
            along[k] = inverse[one][k] - inverse[other][k];
        }
        return along;
    }

    /** The difference of a rating to the weighted mean of all; the weights have the sum 1. */
    public Difference toMean(int bot, double... mean) {
        if (!Arrays.equals(mean, meanWeights)) {
            meanWeights = mean.clone();
            meanAlong = new double[inverse.length];
            meanValue = 0;
            for (int i = 0; i < bots; i++) {
                for (int k = 0; k < meanAlong.length; k++) {
                    meanAlong[k] += mean[i] * inverse[i][k];
                }
                meanValue += mean[i] * ratings[i];
            }
        }
        double[] along = inverse[bot].clone();
        for (int k = 0; k < along.length; k++) {
            along[k] -= meanAlong[k];
        }
        return of(along, ratings[bot] - meanValue);
    }

    /** The variance of a sum along a direction, which has been multiplied by the inverse. */
    Difference of(double[] along, double value) {
        double variance = 0;
        for (int i = 0; i < bots; i++) {
            variance += PRIOR * along[i] * along[i];
        }
        variance += tied ? TIES_PRIOR * along[bots] * along[bots] : 0;
        double played = 0;
        double squares = 0;
        double byFreedom = 0;
        for (int q = 0; q < strata.size(); q++) {
            if (spread.isAny(q)) {
                double part = spread.along(q, along);
                played += part;
                squares += part * part;
                byFreedom += part * part / spread.freedom(q);
            }
        }
        variance += played;
        return new Difference(value, variance,
            byFreedom > 0 ? Math.min(CERTAIN, variance * variance / byFreedom) : CERTAIN,
            played > 0 ? squares / (played * played) : 1);
    }
}
