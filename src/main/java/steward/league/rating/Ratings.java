package steward.league.rating;

import java.util.Arrays;
import java.util.Collections;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;

/**
 * Ratings of several versions of bots, computed from all games between them.
 *
 * @param versions ascending
 * @param fit      in which they have the numbers 0, 1, ...
 */
public record Ratings(List<Integer> versions, RatingFit fit) {

    /** Copies. */
    public Ratings {
        versions = List.copyOf(versions);
    }

    public static Ratings of(Results results, List<Integer> versions) {
        List<Integer> sorted = versions.stream().sorted().toList();
        List<Stratum> strata = results.strata(sorted.stream().mapToInt(Integer::intValue).toArray());
        return new Ratings(sorted, RatingFit.of(sorted.size(), strata, results.alone()));
    }

    /** The rating of a version: its difference to the zero of its component. */
    public Difference rating(int version) {
        return fit.toMean(place(version));
    }

    /** Rating with a bound in place of a bar where the version has won or lost nearly everything. */
    public Difference bounded(int version) {
        return new ScoreTest(fit).boundedToMean(place(version));
    }

    /** The rating of a version: its difference to an anchor of its component, if there is one, or to the zero. */
    public Difference anchored(int version, int anchor) {
        return !versions.contains(anchor) || isAlone(anchor) || !isComparable(version, anchor) ? bounded(version)
            : version == anchor ? Difference.ZERO : bounded(version, anchor);
    }

    /** The difference of two versions, with a bound in place of a bar where one has won or lost nearly everything. */
    public Difference bounded(int one, int other) {
        return new ScoreTest(fit).bounded(place(one), place(other));
    }

    /** True if the ratings of two versions can be compared. */
    public boolean isComparable(int one, int other) {
        return fit.components().together(place(one), place(other));
    }

    /** True if the rating of a version can be compared with no other. */
    public boolean isAlone(int version) {
        return fit.components().isAlone(place(version));
    }

    /** True if a version has won or lost nearly everything within its component, so that it has a bound and no bar. */
    public boolean isExtreme(int version) {
        return new ScoreTest(fit).isExtreme(place(version));
    }

    /** Returns the components, the upper ones first, each from its highest rating. */
    public List<List<Integer>> components() {
        return IntStream.range(0, fit.components().count()).mapToObj(number ->
            Arrays.stream(fit.components().members(number)).boxed()
                .sorted(Comparator.comparingDouble((Integer bot) -> -fit.value(bot)).thenComparing(bot -> bot))
                .map(versions::get).toList()).toList();
    }

    /** Returns the versions from the highest rating, the components one after another. */
    public List<Integer> order() {
        return components().stream().flatMap(List::stream).toList();
    }

    /** Returns the seeds in which the component of one version took every point from that of another. */
    public long sweptSeeds(int one, int other) {
        return fit.sweeps().seeds(fit.components().of(place(one)), fit.components().of(place(other)));
    }

    /** The likelihood of superiority of the first of two versions; NaN where nothing is known. */
    public double superiority(int one, int other) {
        return isComparable(one, other) ? difference(one, other).superiority()
            : fit.sweeps().superiority(place(one), place(other));
    }

    /** Returns how many games a version has played with the others, in whole games of two. */
    public double games(int version) {
        double[] games = new double[1];
        Stratum.each(fit.strata(), (q, k, low, high) ->
            games[0] += low == place(version) || high == place(version) ? fit.strata().get(q).sums[3 * k] : 0);
        return games[0];
    }

    public Difference difference(int one, int other) {
        return fit.difference(place(one), place(other));
    }

    /**
     * True if two versions of which one has won or lost nearly everything are surely not equal; the one that comes
     * first in {@link #order} is the better one then. May be asked at any time.
     *
     * @param alpha the probability with which this may ever be said wrongly
     */
    public boolean isUnequal(int one, int other, double alpha) {
        if (!isComparable(one, other)) {
            return fit.sweeps().isOrdered(place(one), place(other), alpha);
        }
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
     * over some differences. One across components depends on the games of its two bots alone.
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
