package steward.lab.statistics;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import steward.league.rating.AnytimeBar;
import steward.league.rating.RatingFit;
import steward.league.rating.Ratings;
import steward.league.rating.Stratum;

/**
 * Fewest clusters with which a pairing that is fixed beforehand can separate neighbours: the best allocation for
 * somebody who knows all strengths. With n[q] clusters of group q the variance of the difference of the neighbours k is
 * the sum over q of c[k][q] / n[q]; the fewest clusters are sought with which each is at most v[k], the variance of a
 * bar as wide as their distance. By Lagrange's multipliers m, n[q] is the root of the sum over k of m[k] c[k][q]; the
 * multipliers are found by raising those of variances that are too large.
 *
 * @param league bots of a round robin, the strongest first
 */
record BestAllocation(MadeUpLeague league) {

    private static final long MANY = 1L << 30;
    private static final double CERTAIN = 1e9;
    private static final int HALVINGS = 100;
    private static final int STEPS = 20_000;

    /** Returns the clusters needed, as a share of those with which a round robin gets there. */
    double share() {
        int bots = league.bots();
        List<Stratum> strata = league.groups().stream().map(group -> group.inProportion(MANY)).toList();
        List<Integer> versions = IntStream.range(0, bots).boxed().toList();
        double[] even = new double[bots];
        Arrays.fill(even, 1.0 / bots);
        RatingFit fit = RatingFit.of(bots, strata, league.pooled(), league.truth());
        Ratings ratings = new Ratings(versions, fit, even);
        double[][] parts = new double[bots - 1][];
        double inTurn = 0;
        for (int k = 0; k + 1 < bots; k++) {
            double variance = fit.difference(k, k + 1).variance();
            double wanted = wanted(fit.difference(k, k + 1).elo(), AnytimeBar.ALPHA / (bots * (bots - 1) / 2.0));
            parts[k] = ratings.parts(List.of(new int[] {k, k + 1})).values().stream()
                .mapToDouble(part -> part * variance / wanted).toArray();
            inTurn = Math.max(inTurn, Arrays.stream(parts[k]).sum());
        }
        return fewest(parts) / (inTurn * strata.size());
    }

    /** Returns the variance whose anytime bar is so wide. */
    private static double wanted(double elo, double alpha) {
        double low = 0;
        double high = 1;
        for (int k = 0; k < HALVINGS; k++) {
            double middle = (low + high) / 2;
            if (RatingFit.ELO * AnytimeBar.of(middle, CERTAIN, alpha) < elo) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return low;
    }

    /** Returns the least sum of n with all sums of parts[k][q] / n[q] at most 1. */
    private static double fewest(double[]... parts) {
        double[] multipliers = new double[parts.length];
        Arrays.fill(multipliers, 1);
        double[] numbers = new double[parts[0].length];
        double worst = 0;
        for (int step = 0; step < STEPS; step++) {
            for (int q = 0; q < numbers.length; q++) {
                double sum = 0;
                for (int k = 0; k < parts.length; k++) {
                    sum += multipliers[k] * parts[k][q];
                }
                numbers[q] = Math.sqrt(sum);
            }
            worst = 0;
            for (int k = 0; k < parts.length; k++) {
                double found = 0;
                for (int q = 0; q < numbers.length; q++) {
                    found += parts[k][q] / numbers[q];
                }
                multipliers[k] *= found;
                worst = Math.max(worst, found);
            }
        }
        // With so many times more of each, all are within.
        return Arrays.stream(numbers).sum() * worst;
    }
}
