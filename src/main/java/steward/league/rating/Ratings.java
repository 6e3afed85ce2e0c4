package steward.league.rating;

import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * The ratings of some versions of bots, from all games between them.
 *
 * @param versions ascending
 * @param fit      in which they have the numbers 0, 1, ...
 * @param weights  each version's share of the games; all the same where there are none. The mean with these weights is
 *                 0: a bot that has just come does not widen the bars of the others
 */
public record Ratings(List<Integer> versions, RatingFit fit, double... weights) {

    /** Copies. */
    public Ratings {
        versions = List.copyOf(versions);
        weights = weights.clone();
    }

    public static Ratings of(Results results, List<Integer> versions) {
        List<Integer> sorted = versions.stream().sorted().toList();
        List<Stratum> strata = results.strata(sorted.stream().mapToInt(Integer::intValue).toArray());
        return new Ratings(sorted, RatingFit.of(sorted.size(), strata, results.alone()),
            weights(sorted.size(), strata));
    }

    private static double[] weights(int bots, List<Stratum> strata) {
        double[] weights = new double[bots];
        double all = 0;
        for (Stratum stratum : strata) {
            for (int k = 0; k < stratum.pairs(); k++) {
                double games = stratum.sums[3 * k];
                weights[stratum.bots[stratum.low[k]]] += games;
                weights[stratum.bots[stratum.high[k]]] += games;
                all += 2 * games;
            }
        }
        for (int i = 0; i < bots; i++) {
            weights[i] = all > 0 ? weights[i] / all : 1.0 / bots;
        }
        return weights;
    }

    /** The rating of a version: its difference to the mean. */
    public Difference rating(int version) {
        return fit.toMean(place(version), weights);
    }

    /** Rating with a bound in place of a bar where the version has won or lost nearly everything. */
    public Difference bounded(int version) {
        return new ScoreTest(fit).boundedToMean(place(version), weights);
    }

    /** The difference of two versions, with a bound in place of a bar where one has won or lost nearly everything. */
    public Difference bounded(int one, int other) {
        return new ScoreTest(fit).bounded(place(one), place(other));
    }

    public Difference difference(int one, int other) {
        return fit.difference(place(one), place(other));
    }

    /**
     * True if two versions of which one has won or lost nearly everything are surely not equal; the one with the higher
     * rating is the better one then. May be asked at any time.
     *
     * @param alpha the probability with which this may ever be said wrongly
     */
    public boolean isUnequal(int one, int other, double alpha) {
        ScoreTest test = new ScoreTest(fit);
        if (!test.isExtreme(place(one)) && !test.isExtreme(place(other))) {
            return false;
        }
        Difference tested = test.fromEqual(place(one), place(other));
        return Math.abs(tested.elo()) > tested.anytimeBar(alpha)
            && tested.value() * difference(one, other).value() > 0;
    }

    /** The ranks that the games leave the versions, in their order. */
    public List<RankRange> ranks() {
        return List.of(RankRange.all(fit));
    }

    /** Returns the residual of the first against the second beside their ratings. */
    public Residual residual(int one, int other) {
        return fit.residuals().of(place(one), place(other));
    }

    /**
     * By group: the number of its clusters times its part in the variance of a difference, as a share of it, summed up
     * over some differences.
     *
     * @param pairs of versions
     */
    public Map<List<Integer>, Double> parts(List<int[]> pairs) {
        List<Stratum> strata = fit.strata();
        double[][] sums = strata.stream().map(stratum -> new double[stratum.groups.length]).toArray(double[][]::new);
        for (int[] pair : pairs) {
            fit.addParts(place(pair[0]), place(pair[1]), sums);
        }
        Map<List<Integer>, Double> parts = new LinkedHashMap<>();
        for (int q = 0; q < sums.length; q++) {
            for (int group = 0; group < sums[q].length; group++) {
                parts.merge(Arrays.stream(strata.get(q).groups[group]).mapToObj(versions::get).toList(),
                    sums[q][group], Double::sum);
            }
        }
        return parts;
    }

    private int place(int version) {
        return Collections.binarySearch(versions, version);
    }
}
