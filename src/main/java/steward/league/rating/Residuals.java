package steward.league.rating;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Residuals of a fit: for each pair of bots, how far their results deviate from what the ratings predict. */
final class Residuals {

    private final RatingFit fit;
    /** By pair, as the lower place times the number of bots plus the higher one: strata and pairs in which it met. */
    private final Map<Integer, List<int[]>> met = new HashMap<>();

    Residuals(RatingFit fit) {
        this.fit = fit;
        Stratum.each(fit.strata(), (q, k, low, high) ->
            met.computeIfAbsent(low * fit.bots() + high, key -> new ArrayList<>()).add(new int[] {q, k}));
    }

    /** Residual of the games between two bots. */
    Residual of(int one, int other) {
        List<int[]> own = met.getOrDefault(Math.min(one, other) * fit.bots() + Math.max(one, other), List.of());
        double games = 0;
        double points = 0;
        long clusters = 0;
        for (int[] pair : own) {
            Stratum stratum = fit.strata().get(pair[0]);
            double[] sums = stratum.sums;
            int k = pair[1];
            games += sums[3 * k];
            points += one < other ? sums[3 * k + 1] : sums[3 * k] - sums[3 * k + 1];
            clusters += stratum.clusters;
        }
        double share = points / games;
        double expected = fit.expected(one, other);
        if (clusters < RatingFit.WHOLE || Double.isNaN(expected)) {
            return new Residual(share, expected, clusters, 0);
        }
        double squares = 0;
        for (int[] pair : own) {
            Stratum stratum = fit.strata().get(pair[0]);
            int k = pair[1];
            for (int p = 0; p < stratum.size; p++) {
                double played = stratum.patterns[p][3 * k];
                double won = stratum.patterns[p][3 * k + 1];
                double surplus = (one < other ? won : played - won) - played * share;
                squares += stratum.counts[p] * surplus * surplus;
            }
        }
        double freedom = clusters - 1;
        // As in the fit, a part of what the model says: clusters that are all alike are not certain.
        double alike = share * (1 - share) / 2 + expected * (1 - expected) / 2;
        double variance = (squares * clusters / freedom + ClusterSpread.MIXED * games * alike / clusters)
            / (games * games);
        if (Math.min(points, games - points) < ClusterSpread.FEW_POINTS) {
            variance = Math.max(variance, expected * (1 - expected) / games);
        }
        return new Residual(share, expected, clusters,
            Normal.ofStudent((share - expected) / Math.sqrt(variance), freedom));
    }
}
