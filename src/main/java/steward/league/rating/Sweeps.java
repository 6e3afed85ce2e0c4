package steward.league.rating;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Bounds between bots of two {@link Components} of which the upper one took every point. A seed in which it did so is
 * one observation, of at most the chance that its least favourite bot wins a game. If the other bot was as strong, or
 * ahead by some difference, the product of these chances is the likelihood of all the games; divided into 1, that of a
 * component that always wins, it is a test martingale. So it falls below a with a probability of at most a, however
 * often one looks (J. Ville, "Étude critique de la notion de collectif", 1939). Ratings within a component are taken
 * as they are estimated.
 */
final class Sweeps {

    /** Half the probability of a miss: a bound is as sure as either end of a 95% bar. */
    private static final double TAIL = 0.025;
    /** In natural units, as far on the wrong side: 521 Elo. A bound beyond that says nothing, and is none. */
    private static final double FARTHEST = 3;
    private static final double CLOSE = 1e-9;

    private final RatingFit fit;
    /** By upper and lower component: the differences within the seeds, and their numbers. */
    private final Map<List<Integer>, List<double[]>> seeds = new HashMap<>();

    Sweeps(RatingFit fit) {
        this.fit = fit;
        for (Stratum stratum : fit.strata()) {
            add(stratum);
        }
    }

    private void add(Stratum stratum) {
        Components components = fit.components();
        if (stratum.clusters == 0 || components.of(stratum.bots[0]) == components.of(stratum.bots[1])
                && stratum.bots.length == 2) {
            return;
        }
        for (int p = 0; p < stratum.size; p++) {
            Map<List<Integer>, Double> least = new HashMap<>();
            for (int k = 0; k < stratum.pairs(); k++) {
                int one = stratum.bots[stratum.low[k]];
                int other = stratum.bots[stratum.high[k]];
                if (stratum.patterns[p][3 * k] > 0 && !components.together(one, other)) {
                    boolean turned = components.of(one) > components.of(other);
                    double apart = fit.value(turned ? other : one) - fit.value(turned ? one : other);
                    least.merge(List.of(components.of(turned ? other : one), components.of(turned ? one : other)),
                        apart, Math::min);
                }
            }
            long count = stratum.counts[p];
            if (count > 0) {
                least.forEach((key, apart) -> seeds.computeIfAbsent(key, none -> new ArrayList<>())
                    .add(new double[] {apart, count}));
            }
        }
    }

    /** Returns the seeds in which bots of a component took every point from those of another. */
    long seeds(int upper, int lower) {
        return Math.round(seeds.getOrDefault(List.of(upper, lower), List.of()).stream().mapToDouble(each -> each[1])
            .sum());
    }

    /**
     * Returns the logarithm of the likelihood of all seeds, if the first bot was ahead of the second by a difference
     * in natural units; 0 where its component took nothing.
     */
    double logChance(int one, int other, double ahead) {
        double shift = ahead - fit.value(one) + fit.value(other);
        return seeds.getOrDefault(List.of(fit.components().of(one), fit.components().of(other)), List.of()).stream()
            .mapToDouble(each -> -each[1] * StrictMath.log1p(StrictMath.exp(-each[0] - shift))).sum();
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
