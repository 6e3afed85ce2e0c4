package steward.league.rating;

import java.util.stream.IntStream;

/**
 * Range of ranks that a bot may have, at 95%: all bars of its differences to other bots hold together (Bonferroni).
 *
 * @param best the best of them, from 1
 */
public record RankRange(int best, int worst) {

    /** Half the probability that a rank is outside of its range. */
    private static final double TAIL = 0.025;
    private static final double ROUNDING = 1e-9;

    /** Ranges of all bots of a fit, by their places there. */
    public static RankRange[] all(RatingFit fit) {
        int bots = fit.bots();
        int[] above = new int[bots];
        int[] below = new int[bots];
        double z = Normal.above(TAIL / Math.max(1, bots - 1));
        for (int one = 0; one < bots; one++) {
            for (int other = 0; other < one; other++) {
                if (isSure(fit, one, other, z)) {
                    boolean better = fit.components().together(one, other) ? fit.value(one) > fit.value(other)
                        : fit.components().of(one) < fit.components().of(other);
                    above[better ? other : one]++;
                    below[better ? one : other]++;
                }
            }
        }
        return IntStream.range(0, bots).mapToObj(bot -> new RankRange(1 + above[bot], bots - below[bot]))
            .toArray(RankRange[]::new);
    }

    /** True if a difference is beyond its bar. The bar itself is computed only where its bounds do not tell. */
    private static boolean isSure(RatingFit fit, int one, int other, double z) {
        if (!fit.components().together(one, other)) {
            return fit.sweeps().isOrdered(one, other, 2 * (1 - Normal.below(z)));
        }
        Covariance all = fit.covariance();
        double deviations = Math.abs(fit.value(one) - fit.value(other)) / Math.sqrt(all.variance(one, other));
        if (deviations < z * (1 - ROUNDING)) {
            return false;
        }
        if (deviations > Normal.student(z, all.leastFreedom(one, other)) * (1 + ROUNDING)) {
            return true;
        }
        Difference difference = fit.difference(one, other);
        return Math.abs(difference.elo()) > difference.bar(z);
    }
}
