package steward.league.rating;

import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.IntStream;

/**
 * Score test of a rating difference: fits the ratings under that difference, and tests what the games still ask for.
 * Source: D. D. Boos, "On generalized score tests", American Statistician 46, 1992, here with the sandwich. If a bot
 * has won or lost nearly everything, the likelihood is flat and its top far out, so that its curvature is useless for
 * hundreds of games; this test works there, since n wins are about the root of n standard deviations. The clusters'
 * squares around the tested value grow with their distance, so that a few clusters that are alike do not seem certain;
 * degrees of freedom are not needed.
 */
public final class ScoreTest {

    /** Shares of the points beyond which hardly anything went the other way, so that its variance is not known. */
    private static final double EXTREME = 0.05;
    /** Shares beyond which that is so where {@link #FEW} points went the other way at most. */
    private static final double RARE = 0.1;
    private static final double FEW = 3;
    /** In natural units: a fifth of a point of Elo. */
    private static final double CLOSE = 1e-3;
    /** In natural units, as far on the other side of 0: 521 Elo. A bound beyond that says nothing, and is none. */
    private static final double FARTHEST = 3;
    private static final double ROUNDING = 1e-9;
    /** Bots up to which all are fitted anew for each value that is tested. */
    private static final int MOST_FITTED = 30;

    private final RatingFit fit;

    /** @param fit whose ratings are tested */
    public ScoreTest(RatingFit fit) {
        this.fit = fit;
    }

    /** True if a bot has lost or won nearly everything: all but 5% of the points, or but 10% and at most 3 points. */
    boolean isExtreme(int bot) {
        double share = Math.min(fit.share(bot), 1 - fit.share(bot));
        return share <= EXTREME + ROUNDING || share <= RARE + ROUNDING && share * fit.games(bot) <= FEW + ROUNDING;
    }

    /** The difference of two ratings seen from where they are equal. It tests whether they are, and is no estimate. */
    public Difference fromEqual(int one, int other) {
        RatingFit.HeldFit held = fit.held(contrast(one, other), 0);
        Difference found = held.fit().difference(one, other);
        return new Difference(found.value() + held.step()[one] - held.step()[other], found.variance(),
            RatingFit.CERTAIN, 1);
    }

    /**
     * The difference of two ratings; one-sided if one of them is extreme and there are not too many to be fitted, or if
     * they are of two components.
     */
    public Difference bounded(int one, int other) {
        Difference found = fit.difference(one, other);
        return fit.components().together(one, other) && fit.bots() <= MOST_FITTED
            && (isExtreme(one) || isExtreme(other))
            ? bounded(found, value -> asked(contrast(one, other), value)) : found;
    }

    /** The difference of a rating to the zero of its component; one-sided if the bot is extreme. */
    public Difference boundedToMean(int bot) {
        Difference found = fit.toMean(bot);
        if (fit.components().isAlone(bot) || !isExtreme(bot)) {
            return found;
        }
        double[] mean = fit.meanWeights(bot);
        if (fit.bots() > MOST_FITTED) {
            double others = fit.value(bot) - found.value() / (1 - mean[bot]);
            return bounded(found, value -> asked(bot, others + value / (1 - mean[bot])));
        }
        double[] contrast = IntStream.range(0, fit.bots()).mapToDouble(i -> (i == bot ? 1 : 0) - mean[i]).toArray();
        return bounded(found, value -> asked(contrast, value));
    }

    private double[] contrast(int one, int other) {
        double[] contrast = new double[fit.bots()];
        contrast[one] = 1;
        contrast[other] = -1;
        return contrast;
    }

    /**
     * Finds the value below the estimate, or above if that is negative, from which the games just ask
     * {@link Difference#Z} standard deviations away. It may be of the other sign: then even the order is open. Farther
     * than {@link #FARTHEST} it is left out.
     */
    private static Difference bounded(Difference found, DoubleUnaryOperator asked) {
        double sign = Math.signum(found.value());
        double outer = found.value();
        double inner = 0;
        while (asked.applyAsDouble(inner) * sign < Difference.Z) {
            if (sign == 0 || Math.abs(inner) >= FARTHEST) {
                return found.unknown();
            }
            outer = inner;
            inner -= sign;
        }
        while (Math.abs(outer - inner) > CLOSE) {
            double middle = (inner + outer) / 2;
            if (asked.applyAsDouble(middle) * sign >= Difference.Z) {
                inner = middle;
            } else {
                outer = middle;
            }
        }
        return found.oneSided(inner);
    }

    /**
     * Number of standard deviations that the games ask for. The variance is at least the model's: few games that went
     * the other way vary as a Poisson number does whose mean is the one that is tested, and not the one that was seen.
     */
    private double asked(double[] contrast, double value) {
        RatingFit.HeldFit held = fit.held(contrast, value);
        RatingFit at = held.fit();
        double[] along = new double[at.inverse().length];
        double asked = 0;
        for (int i = 0; i < contrast.length; i++) {
            asked += contrast[i] * held.step()[i];
            for (int k = 0; k < along.length; k++) {
                along[k] += contrast[i] * at.inverse()[i][k];
            }
        }
        double told = 0;
        for (int q = 0; q < at.strata().size(); q++) {
            told += at.spread().modelled(q, along);
        }
        return asked / Math.sqrt(Math.max(at.of(along, 0).variance(), told));
    }

    /**
     * Number of standard deviations that the games of a bot ask it to go from a rating, the others being held.
     *
     * @param rating in natural units
     */
    private double asked(int bot, double rating) {
        double[] moved = IntStream.range(0, fit.bots()).mapToDouble(fit::value).toArray();
        moved[bot] = rating;
        List<Stratum> strata = fit.strata();
        List<Stratum> own = new ArrayList<>();
        List<double[]> weighted = new ArrayList<>();
        double[] surplus = new double[1];
        Stratum.each(strata, (q, k, low, high) -> {
            if (low == bot || high == bot) {
                if (own.isEmpty() || own.get(own.size() - 1) != strata.get(q)) {
                    own.add(strata.get(q));
                    weighted.add(fit.weights[q]);
                }
                double points = RatingFit.points(moved[low] - moved[high]);
                double[] sums = strata.get(q).sums;
                double pushed = fit.weights[q][k] * (sums[3 * k + 1] - sums[3 * k] * points);
                surplus[0] += low == bot ? pushed : -pushed;
            }
        });
        ClusterSpread tested = new ClusterSpread(own, weighted.toArray(double[][]::new), moved, 1, true,
            fit.inverse());
        double[] along = new double[fit.inverse().length];
        along[bot] = 1;
        double seen = 0;
        double told = 0;
        for (int q = 0; q < own.size(); q++) {
            seen += tested.isAny(q) ? tested.along(q, along) : 0;
            told += tested.modelled(q, along);
        }
        return surplus[0] / Math.sqrt(Math.max(seen, told));
    }
}
