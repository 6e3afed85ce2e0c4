package steward.league.promise;

import java.util.Arrays;
import java.util.List;
import java.util.function.DoublePredicate;
import java.util.stream.IntStream;
import steward.league.rating.AnytimeBar;
import steward.league.rating.RatingFit;
import steward.league.rating.Ratings;

/**
 * Fewest clusters with which a pairing that is fixed beforehand separates neighbours, for somebody who knows all
 * strengths. With n[q] clusters of group q the variance of the difference of the neighbours k is the sum over q of
 * c[k][q] / n[q]; each is to be at most that of a bar as wide as their distance. By Lagrange's multipliers m, n[q] is
 * the root of the sum over k of m[k] c[k][q]; they are found by raising those of variances that are too large.
 */
final class BestAllocation {

    private BestAllocation() { }

    /** Returns the clusters needed, as a share of those of a round robin. @param league the strongest first */
    static double share(MadeUpLeague league) {
        int bots = league.bots();
        RatingFit fit = league.truth();
        Ratings ratings = new Ratings(IntStream.range(0, bots).boxed().toList(), fit);
        double[][] parts = new double[bots - 1][];
        for (int k = 0; k < parts.length; k++) {
            double elo = fit.difference(k, k + 1).elo();
            double alpha = AnytimeBar.ALPHA / league.pairs();
            double wanted = bound(0, 1, variance -> RatingFit.ELO * AnytimeBar.of(variance, 1e9, alpha) < elo);
            double ratio = fit.difference(k, k + 1).variance() / wanted;
            parts[k] = ratings.parts(List.of(new int[] {k, k + 1})).values().stream().mapToDouble(part -> part * ratio)
                .toArray();
        }
        double inTurn = Arrays.stream(parts).mapToDouble(part -> Arrays.stream(part).sum()).max().orElseThrow();
        double[] multipliers = new double[parts.length];
        Arrays.fill(multipliers, 1);
        double[] numbers = new double[league.groups().size()];
        double worst = 0;
        for (int step = 0; step < 20_000; step++) {
            Arrays.setAll(numbers, q -> Math.sqrt(IntStream.range(0, parts.length)
                .mapToDouble(k -> multipliers[k] * parts[k][q]).sum()));
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
        return Arrays.stream(numbers).sum() * worst / (inTurn * numbers.length);
    }

    /** Returns the least number between two of which something does not hold that holds of all lower ones. */
    static double bound(double least, double most, DoublePredicate holds) {
        double low = least;
        double high = most;
        for (int halving = 0; halving < 100; halving++) {
            double middle = (low + high) / 2;
            boolean below = holds.test(middle);
            low = below ? middle : low;
            high = below ? high : middle;
        }
        return low;
    }
}
