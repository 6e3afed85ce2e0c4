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
    /** Of the logarithm of the weight of ties, whose standard deviation is 3: a factor of 20. */
    static final double TIES_PRIOR = 1.0 / 9;
    private static final int MOST_STEPS = 100;
    /** A longer step is shortened: far from the top the parabola is a poor guide. */
    private static final double LONGEST_STEP = 2;
    private static final double CLOSE = 1e-10;
    /** Degrees of freedom of a variance that is known. */
    private static final double CERTAIN = 1e9;

    private final int bots;
    private final List<Stratum> strata;
    /** The weight of a game of each pair of each stratum. */
    private final double[][] weights;
    private final double[] ratings;
    private boolean tied;
    private double logTies;
    private double[][] inverse;
    private ClusterSpread spread;

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
        fit.spread = new ClusterSpread(strata, fit.weights, fit.ratings, fit.tied, fit.ties(), fit.inverse);
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
        double variance = (squares[0] * clusters[0] / freedom + ClusterSpread.MIXED * sums[0] * alike / clusters[0])
            / (sums[0] * sums[0]);
        if (Math.min(sums[1], sums[0] - sums[1]) < ClusterSpread.FEW_POINTS) {
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
        for (int q = 0; q < strata.size(); q++) {
            if (spread.isAny(q)) {
                taker.take(strata.get(q).bots, spread.along(q, along) * strata.get(q).clusters / variance);
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
        for (int q = 0; q < strata.size(); q++) {
            if (spread.isAny(q)) {
                double part = spread.along(q, along);
                variance += part;
                squares += part * part / spread.freedom(q);
            }
        }
        return new Difference(value, variance,
            squares > 0 ? Math.min(CERTAIN, variance * variance / squares) : CERTAIN);
    }
}
