package steward.league.rating;

/**
 * Ratings by the model of Bradley and Terry (R. A. Bradley and M. E. Terry, "Rank analysis of incomplete block designs:
 * I. The method of paired comparisons", Biometrika 39, 1952): the chance that i beats j is 1 / (1 + exp(rj - ri)). All
 * games are fitted together; a draw is half a win. A weak normal prior keeps a bot that has won everything finite, and
 * holds together bots that have never met.
 *
 * <p>Found by Newton's method on the logarithm of the posterior, which is concave. The covariance is the inverse of its
 * negative second derivative (Laplace's approximation); the bars are those of the difference to the mean of
 * all, in which each bot has the weight of its games: one that has just come does not widen the bars of the others.
 *
 * <p>Caveat: games count as independent, although two games on one seed are not quite.
 */
public final class BradleyTerry {

    /** Elo points for a factor of e in the odds: 400 / ln 10. */
    public static final double ELO = 173.7177927613007;
    /** The standard normal quantile of 0.975. */
    private static final double Z = 1.959963984540054;
    /** The prior's standard deviation, in Elo: strengths of 95% of all bots within about 3000. */
    private static final double PRIOR_ELO = 750;
    private static final double PRIOR = ELO * ELO / (PRIOR_ELO * PRIOR_ELO);
    private static final int MOST_STEPS = 100;
    /** A longer step is shortened: far from the top the parabola is a poor guide. */
    private static final double LONGEST_STEP = 2;
    private static final double CLOSE = 1e-10;

    private final double[] ratings;
    private final double[] bars;

    private BradleyTerry(double[] ratings, double[] bars) {
        this.ratings = ratings;
        this.bars = bars;
    }

    /**
     * Fits.
     *
     * @param points of the row's bot in games against the column's
     * @param games  between them, the same both ways
     */
    public static BradleyTerry fit(double[][] points, double[][] games) {
        int bots = points.length;
        double[] ratings = new double[bots];
        double[][] curvature = new double[bots][bots];
        double[] slope = new double[bots];
        for (int step = 0; step < MOST_STEPS; step++) {
            derivatives(points, games, ratings, slope, curvature);
            double[] change = solve(cholesky(curvature), slope);
            double longest = 0;
            for (double each : change) {
                longest = Math.max(longest, Math.abs(each));
            }
            double factor = longest > LONGEST_STEP ? LONGEST_STEP / longest : 1;
            for (int i = 0; i < bots; i++) {
                ratings[i] += factor * change[i];
            }
            if (longest < CLOSE) {
                break;
            }
        }
        derivatives(points, games, ratings, slope, curvature);
        return centred(ratings, inverse(cholesky(curvature)), weights(games));
    }

    /** Each bot's share of the games; all the same where there are none. */
    private static double[] weights(double[][] games) {
        double[] weights = new double[games.length];
        double all = 0;
        for (int i = 0; i < games.length; i++) {
            for (double each : games[i]) {
                weights[i] += each;
            }
            all += weights[i];
        }
        for (int i = 0; i < games.length; i++) {
            weights[i] = all > 0 ? weights[i] / all : 1.0 / games.length;
        }
        return weights;
    }

    private static void derivatives(double[][] points, double[][] games, double[] ratings, double[] slope,
                                    double[][] curvature) {
        int bots = ratings.length;
        for (int i = 0; i < bots; i++) {
            slope[i] = -PRIOR * ratings[i];
            curvature[i][i] = PRIOR;
        }
        for (int i = 0; i < bots; i++) {
            for (int j = 0; j < i; j++) {
                double chance = 1 / (1 + StrictMath.exp(ratings[j] - ratings[i]));
                double weight = games[i][j] * chance * (1 - chance);
                double surplus = points[i][j] - games[i][j] * chance;
                slope[i] += surplus;
                slope[j] -= surplus;
                curvature[i][i] += weight;
                curvature[j][j] += weight;
                curvature[i][j] = -weight;
                curvature[j][i] = -weight;
            }
        }
    }

    /** The lower triangle L with L Lᵀ the matrix, which is positive definite by its prior. */
    private static double[][] cholesky(double[][] matrix) {
        int size = matrix.length;
        double[][] lower = new double[size][size];
        for (int i = 0; i < size; i++) {
            for (int j = 0; j <= i; j++) {
                double sum = matrix[i][j];
                for (int k = 0; k < j; k++) {
                    sum -= lower[i][k] * lower[j][k];
                }
                lower[i][j] = i == j ? Math.sqrt(sum) : sum / lower[j][j];
            }
        }
        return lower;
    }

    private static double[] solve(double[][] lower, double[] right) {
        int size = right.length;
        double[] x = right.clone();
        for (int i = 0; i < size; i++) {
            for (int k = 0; k < i; k++) {
                x[i] -= lower[i][k] * x[k];
            }
            x[i] /= lower[i][i];
        }
        for (int i = size - 1; i >= 0; i--) {
            for (int k = i + 1; k < size; k++) {
                x[i] -= lower[k][i] * x[k];
            }
            x[i] /= lower[i][i];
        }
        return x;
    }

    private static double[][] inverse(double[][] lower) {
        int size = lower.length;
        double[][] inverse = new double[size][];
        for (int i = 0; i < size; i++) {
            double[] unit = new double[size];
            unit[i] = 1;
            inverse[i] = solve(lower, unit);
        }
        return inverse;
    }

    /** Ratings and bars of the differences to the weighted mean. */
    private static BradleyTerry centred(double[] ratings, double[][] covariance, double... weights) {
        int bots = ratings.length;
        double mean = 0;
        double all = 0;
        double[] row = new double[bots];
        for (int i = 0; i < bots; i++) {
            mean += ratings[i] * weights[i];
            for (int j = 0; j < bots; j++) {
                row[i] += covariance[i][j] * weights[j];
            }
            all += row[i] * weights[i];
        }
        double[] elo = new double[bots];
        double[] bars = new double[bots];
        for (int i = 0; i < bots; i++) {
            elo[i] = ELO * (ratings[i] - mean);
            bars[i] = Z * ELO * Math.sqrt(Math.max(0, covariance[i][i] - 2 * row[i] + all));
        }
        return new BradleyTerry(elo, bars);
    }

    /** In Elo; the mean of all, weighted by their games, is 0. */
    public double rating(int bot) {
        return ratings[bot];
    }

    /** Half the width of the 95% bar of {@link #rating}, in Elo. */
    public double bar(int bot) {
        return bars[bot];
    }
}
