package steward.league.rating;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.ObjLongConsumer;

/**
 * Bounds on the rating difference between two {@link Components} if the upper one took every point. A seed in which it
 * did so is one observation, with a probability of at most the chance that its least favourite bot wins a game. If the
 * other bot was as strong, or ahead by some difference, the product of these chances is the likelihood of all the
 * games. Its inverse is the likelihood ratio against a component that always wins, a test martingale. So the product
 * falls below a with a probability of at most a, however often one looks (J. Ville, "Étude critique de la notion de
 * collectif", 1939).
 *
 * <p>The seeds in which both bots met need no other rating. If they never met, seeds between other bots of their
 * components count; differences within a component are then taken at the least favourable end of their anytime bars,
 * which have half of the permitted errors.
 */
final class Sweeps {

    /** Half the probability of a miss: a bound is as sure as either end of a 95% bar. */
    private static final double TAIL = 0.025;
    /** In natural units, as far on the wrong side: 521 Elo. A bound beyond that says nothing, and is none. */
    private static final double FARTHEST = 3;
    private static final double CLOSE = 1e-9;

    private final RatingFit fit;
    /** By upper and lower component: the seeds in which they met. */
    private final Map<List<Integer>, Long> seeds = new HashMap<>();
    /** By upper and lower bot: the seeds in which they met. */
    private final Map<List<Integer>, Long> met = new HashMap<>();
    /** By upper and lower bot that never met: how far apart others are beside them, and in how many seeds they met. */
    private final Map<List<Integer>, List<double[]>> others = new HashMap<>();

    Sweeps(RatingFit fit) {
        this.fit = fit;
        eachSeed((pairs, count) -> {
            pairs.forEach(pair -> met.merge(pair, count, Long::sum));
            pairs.stream().map(pair -> List.of(fit.components().of(pair.get(0)), fit.components().of(pair.get(1))))
                .distinct().forEach(pair -> seeds.merge(pair, count, Long::sum));
        });
    }

    /** @param seeds takes the upper and lower bots that met in some equal seeds, and their number */
    private void eachSeed(ObjLongConsumer<List<List<Integer>>> seeds) {
        for (Stratum stratum : fit.strata()) {
            for (int p = 0; p < stratum.size; p++) {
                List<List<Integer>> pairs = new ArrayList<>();
                for (int k = 0; stratum.counts[p] > 0 && k < stratum.pairs(); k++) {
                    int one = stratum.bots[stratum.low[k]];
                    int other = stratum.bots[stratum.high[k]];
                    if (stratum.patterns[p][3 * k] > 0 && !fit.components().together(one, other)) {
                        pairs.add(isAbove(one, other) ? List.of(one, other) : List.of(other, one));
                    }
                }
                if (!pairs.isEmpty()) {
                    seeds.accept(pairs, stratum.counts[p]);
                }
            }
        }
    }

    private boolean isAbove(int one, int other) {
        return fit.components().of(one) < fit.components().of(other);
    }

    /** Returns the seeds in which bots of a component took every point from those of another. */
    long seeds(int upper, int lower) {
        return seeds.getOrDefault(List.of(upper, lower), 0L);
    }

    /**
     * Returns the logarithm of the likelihood of all seeds, if the first bot was ahead of the second by a difference
     * in natural units; 0 where its component took nothing.
     */
    double logChance(int one, int other, double ahead) {
        List<Integer> pair = List.of(one, other);
        if (met.containsKey(pair)) {
            return met.get(pair) * logPoints(ahead);
        }
        double sum = others.computeIfAbsent(pair, key -> ofOthers(one, other)).stream()
            .mapToDouble(each -> each[1] * logPoints(ahead + each[0])).sum();
        return Math.min(0, sum + StrictMath.log(2));
    }

    private static double logPoints(double difference) {
        return -StrictMath.log1p(StrictMath.exp(-difference));
    }

    private List<double[]> ofOthers(int one, int other) {
        Components components = fit.components();
        List<double[]> found = new ArrayList<>();
        if (isAbove(one, other) && seeds(components.of(one), components.of(other)) > 0) {
            double[] most = new double[fit.bots()];
            Arrays.setAll(most, bot -> components.together(bot, one) ? most(bot, one)
                : components.together(bot, other) ? most(other, bot) : 0);
            eachSeed((pairs, count) -> pairs.stream().filter(pair -> components.together(pair.get(0), one)
                && components.together(pair.get(1), other)).mapToDouble(pair -> most[pair.get(0)] + most[pair.get(1)])
                .min().ifPresent(least -> found.add(new double[] {least, count})));
        }
        return found;
    }

    /** The upper end of a difference within a component, by a bar with its part of half the permitted errors. */
    private double most(int one, int other) {
        return one == other ? 0 : fit.value(one) - fit.value(other) + fit.difference(one, other)
            .anytimeBar(AnytimeBar.ALPHA / fit.bots() / (fit.bots() - 1)) / RatingFit.ELO;
    }

    /** Returns the difference of two bots of different components: a bound or nothing. */
    Difference difference(int one, int other) {
        if (fit.components().of(one) > fit.components().of(other)) {
            Difference turned = difference(other, one);
            return turned.isOneSided() ? Difference.beyond(-turned.bound(), false) : turned;
        }
        double wanted = StrictMath.log(TAIL);
        double low = -FARTHEST;
        if (logChance(one, other, low) > wanted) {
            return Difference.NONE;
        }
        double high = 0;
        while (logChance(one, other, high) < wanted) {
            high += 1;
        }
        while (high - low > CLOSE) {
            double middle = (low + high) / 2;
            if (logChance(one, other, middle) > wanted) {
                high = middle;
            } else {
                low = middle;
            }
        }
        return Difference.beyond(low, true);
    }

    /** True if one of two bots of different components is the better one, wrongly so with the probability alpha. */
    boolean isOrdered(int one, int other, double alpha) {
        return logChance(one, other, 0) + logChance(other, one, 0) <= StrictMath.log(alpha / 2);
    }

    /**
     * Returns the likelihood of superiority of the first of two bots of different components; NaN if nothing is known.
     * It is 1 - L/2 with L the likelihood if both are equal; of two bots alone, 1 - 1/2^(n+1), the posterior of a
     * chance of which nothing was known before.
     */
    double superiority(int one, int other) {
        double above = logChance(one, other, 0);
        double below = logChance(other, one, 0);
        return above < 0 ? 1 - StrictMath.exp(above) / 2 : below < 0 ? StrictMath.exp(below) / 2 : Double.NaN;
    }
}
