package steward.league.rating;

import java.util.Arrays;
import java.util.List;

/**
 * Elo ratings fitted jointly to all clusters. The expected points of a bot in a game are {@code 1/(1 + exp(-d))}, with
 * d its rating less the other's in natural units. At the fit, each bot's weighted sum of points less expected points is
 * 0. A draw is half a point, however often games are drawn. Ratings are given within {@link Components}, where these
 * equations have one solution; games between two components give a bound (see {@link Sweeps}). docs/rating.md has the
 * formulas.
 *
 * <p><b>Weights.</b> If results are not transitive, no rating reproduces all of them, and a fit that weighs every game
 * alike depends on who was paired how often. Here a pairing's games weigh as if all pairings were played equally often:
 * ratings estimate the fit under uniform pairing. A pairing with n clusters, fewer than {@link #WHOLE}, has n/8 of a
 * weight. In games of three and more players, pairing means the group.
 *
 * <p><b>Zero.</b> The zero of a component is the weighted mean of its ratings. A rating's weight is the sum of p (1 -
 * p) over its games, p the expected points; so a newcomer, or a bot that nearly always loses, does not widen the bars
 * of the others.
 *
 * <p><b>Covariance.</b> The covariance is that of an M-estimate over clusters, the sandwich A^-1 B A^-1; {@link
 * ClusterSpread} is B. Degrees of freedom after Satterthwaite (Biometrics Bulletin 2, 1946).
 * Over 400 lines, because fit, covariance and degrees of freedom share the same sums.
 */
public final class RatingFit {

    /** Elo points for a factor of e in the odds: 400 / ln 10. */
    public static final double ELO = 173.7177927613007;
    /** Clusters from which a pairing has its whole weight, and its own mean. */
    static final int WHOLE = 8;
    /** Variance of games that counts as played without ties: that of two even games. */
    private static final double UNTIED = 0.5;
    private static final int MOST_STEPS = 100;
    /** A longer step is shortened: far from the solution the tangent is a poor guide. */
    private static final double LONGEST_STEP = 2;
    private static final double CLOSE = 1e-10;
    /** Pull between two ratings that are held together, as a multiple of the games'. */
    private static final double HELD = 10_000;
    /** Degrees of freedom of a variance that is known. */
    static final double CERTAIN = 1e9;

    private final int bots;
    private final List<Stratum> strata;
    private final Components components;
    /** The weight of a game of each pair of each stratum. */
    final double[][] weights;
    private final double[] ratings;
    /** Weighted points and games of each bot, within its component. */
    private final double[] points;
    private final double[] games;
    /** Sum of p (1 - p) over each bot's games within its component, without weights. */
    private final double[] information;
    private double dispersion;
    private double[][] inverse;
    private ClusterSpread spread;
    private Covariance covariance;
    private Residuals residuals;
    private Sweeps sweeps;
    /** By component: the mean of its ratings, and its direction multiplied by the inverse; as they are asked for. */
    private final double[][] meanAlong;
    private final double[] meanValue;

    private RatingFit(int bots, List<Stratum> strata, Components components, double[]... weights) {
        this.bots = bots;
        this.strata = strata;
        this.components = components;
        ratings = new double[bots];
        points = new double[bots];
        games = new double[bots];
        information = new double[bots];
        this.weights = weights;
        meanAlong = new double[components.count()][];
        meanValue = new double[components.count()];
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
        Components components = Components.of(bots, strata);
        RatingFit fit = new RatingFit(bots, strata, components, PairingWeights.of(strata, pooled, components));
        fit.solve(near, null);
        fit.spread = new ClusterSpread(strata, fit.weights, fit.ratings, fit.dispersion, false, fit.inverse);
        return fit;
    }

    /** Expected points of a game. @param difference of the ratings, in natural units */
    static double points(double difference) {
        return 1 / (1 + StrictMath.exp(-difference));
    }

    // ---- the solution ----------------------------------------------------------------------------

    /**
     * Newton's method: the surplus is the slope of a concave function, the logarithm of the likelihood of games without
     * ties.
     *
     * @param held what is held, or {@code null}
     * @return the step that would come next; with something that is held, if it were let go
     */
    private double[] solve(RatingFit near, Held held) {
        double[][] sums = new double[3][bots * bots];
        double[] ties = new double[1];
        Stratum.each(strata, (q, k, low, high) -> {
            double[] own = strata.get(q).sums;
            sums[0][low * bots + high] += weights[q][k] * own[3 * k];
            sums[1][low * bots + high] += weights[q][k] * own[3 * k + 1];
            sums[2][low * bots + high] += components.together(low, high) ? own[3 * k] : 0;
            ties[0] += components.together(low, high) ? own[3 * k + 2] : 0;
        });
        for (int k = 0; k < sums[0].length; k++) {
            games[k / bots] += sums[0][k];
            games[k % bots] += sums[0][k];
            points[k / bots] += sums[1][k];
            points[k % bots] += sums[0][k] - sums[1][k];
        }
        if (near != null) {
            System.arraycopy(near.ratings, 0, ratings, 0, bots);
            centre();
        }
        double[] slope = new double[bots];
        double[][] curvature = new double[bots][bots];
        Cholesky factor = null;
        for (int step = 0; step < MOST_STEPS; step++) {
            derivatives(sums, slope, curvature);
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
            if (longest < CLOSE) {
                break;
            }
        }
        if (held != null) {
            derivatives(sums, slope, curvature);
            factor = new Cholesky(curvature);
        }
        inverse = factor.inverse();
        // A game's variance is p (1 - p) - t/4, t the chance of a tie; as a share of p (1 - p) the same for all games.
        double untied = Arrays.stream(information).sum() / 2 + UNTIED;
        dispersion = Math.max(UNTIED, untied - ties[0] / 4) / untied;
        return factor.solve(slope);
    }

    private void centre() {
        for (int number = 0; number < components.count(); number++) {
            int[] own = components.members(number);
            double mean = Arrays.stream(own).mapToDouble(bot -> ratings[bot]).sum() / own.length;
            for (int bot : own) {
                ratings[bot] -= mean;
            }
        }
    }

    /**
     * A sum of ratings of one component that is held at a value.
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
     * Fits with a sum of ratings of one component held.
     *
     * @param contrast by bot, what the sum has of its rating; together 0
     */
    HeldFit held(double[] contrast, double value) {
        RatingFit fit = new RatingFit(bots, strata, components, weights);
        double[] step = fit.solve(this, new Held(contrast, value));
        fit.spread = new ClusterSpread(strata, weights, fit.ratings, 1, true, fit.inverse);
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

    private void derivatives(double[][] sums, double[] slope, double[][] curvature) {
        Arrays.fill(slope, 0);
        Arrays.fill(information, 0);
        for (double[] row : curvature) {
            Arrays.fill(row, 0);
        }
        for (int i = 0; i < bots; i++) {
            for (int j = i + 1; j < bots; j++) {
                double games = sums[0][i * bots + j];
                if (!(games > 0)) {
                    continue;
                }
                double expected = points(ratings[i] - ratings[j]);
                double surplus = sums[1][i * bots + j] - games * expected;
                double weight = games * expected * (1 - expected);
                slope[i] += surplus;
                slope[j] -= surplus;
                curvature[i][i] += weight;
                curvature[j][j] += weight;
                curvature[i][j] -= weight;
                curvature[j][i] -= weight;
                information[i] += sums[2][i * bots + j] * expected * (1 - expected);
                information[j] += sums[2][i * bots + j] * expected * (1 - expected);
            }
        }
        for (int number = 0; number < components.count(); number++) {
            pin(components.members(number), slope, curvature);
        }
    }

    /** Keeps the sum of a component's ratings at 0, which no game tells; it changes nothing in their differences. */
    private void pin(int[] own, double[] slope, double[]... curvature) {
        double sum = 0;
        double weight = 0;
        for (int i : own) {
            sum += ratings[i];
            weight += curvature[i][i] / own.length / own.length;
        }
        weight = own.length == 1 ? 1 : weight;
        for (int i : own) {
            slope[i] -= weight * sum;
            for (int j : own) {
                curvature[i][j] += weight;
            }
        }
    }

    // ---- what can be asked -----------------------------------------------------------------------

    List<Stratum> strata() {
        return strata;
    }

    public int bots() {
        return bots;
    }

    /** Returns which bots can be compared. */
    public Components components() {
        return components;
    }

    /** In Elo, from the unweighted mean of its component. */
    public double rating(int bot) {
        return ELO * ratings[bot];
    }

    /** Expected points of one bot in a game against another of its component; otherwise NaN. */
    public double expected(int one, int other) {
        return components.together(one, other) ? points(ratings[one] - ratings[other]) : Double.NaN;
    }

    /** Bounds across components, from where they are asked for the first time. */
    Sweeps sweeps() {
        if (sweeps == null) {
            sweeps = new Sweeps(this);
        }
        return sweeps;
    }

    /** Residuals of all pairs, from where they are asked for the first time. */
    Residuals residuals() {
        if (residuals == null) {
            residuals = new Residuals(this);
        }
        return residuals;
    }

    /** Returns the difference of two ratings; across components a bound or nothing. */
    public Difference difference(int one, int other) {
        return components.together(one, other) ? of(along(one, other), ratings[one] - ratings[other])
            : sweeps().difference(one, other);
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

    double[][] inverse() {
        return inverse;
    }

    /**
     * Adds by stratum and group: its number of clusters times its part in the variance of a difference, as a share of
     * it. That is what one cluster more takes away, times the square of the number. Variances are those that the model
     * tells; across components all of a difference is with the games of its two bots.
     */
    void addParts(int one, int other, double[]... parts) {
        double[] along = along(one, other);
        double variance = 0;
        double[][] own = new double[parts.length][];
        for (int q = 0; q < parts.length; q++) {
            own[q] = new double[parts[q].length];
            for (int k = 0; spread.isAny(q) && k < strata.get(q).pairs(); k++) {
                double part = components.together(one, other) ? spread.modelledPair(q, k, along)
                    : strata.get(q).isOf(k, one, other) ? strata.get(q).clusters : 0;
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

    /** The weights of the mean that is the zero of a bot's component; the others' are 0. */
    public double[] meanWeights(int bot) {
        double[] mean = new double[bots];
        int[] own = components.members(components.of(bot));
        double all = 0;
        for (int each : own) {
            all += information[each];
        }
        for (int each : own) {
            mean[each] = all > 0 ? information[each] / all : 1.0 / own.length;
        }
        return mean;
    }

    /** The difference of a rating to the zero of its component; nothing for a bot that is alone. */
    public Difference toMean(int bot) {
        if (components.isAlone(bot)) {
            return Difference.NONE;
        }
        int number = components.of(bot);
        if (meanAlong[number] == null) {
            double[] mean = meanWeights(bot);
            meanAlong[number] = new double[bots];
            for (int i = 0; i < bots; i++) {
                for (int k = 0; mean[i] > 0 && k < bots; k++) {
                    meanAlong[number][k] += mean[i] * inverse[i][k];
                }
                meanValue[number] += mean[i] * ratings[i];
            }
        }
        double[] along = inverse[bot].clone();
        for (int k = 0; k < along.length; k++) {
            along[k] -= meanAlong[number][k];
        }
        return of(along, ratings[bot] - meanValue[number]);
    }

    /** The variance of a sum along a direction, which has been multiplied by the inverse. */
    Difference of(double[] along, double value) {
        double variance = 0;
        double squares = 0;
        double byFreedom = 0;
        for (int q = 0; q < strata.size(); q++) {
            if (spread.isAny(q)) {
                double part = spread.along(q, along);
                variance += part;
                squares += spread.isOfOnePair(q, along) ? part * part : 0;
                byFreedom += part * part / spread.freedom(q);
            }
        }
        return new Difference(value, variance,
            byFreedom > 0 ? Math.min(CERTAIN, variance * variance / byFreedom) : CERTAIN,
            variance > 0 ? squares / (variance * variance) : 1);
    }
}
