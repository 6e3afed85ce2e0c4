package steward.league.rating;

import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Weights of games in the fit. All pairings with {@link RatingFit#WHOLE} clusters or more have the same total weight;
 * pairings with fewer have a part of it; all weights add up to the number of games. Games between bots whose ratings
 * cannot be compared have weight 0.
 */
final class PairingWeights {

    /** Returns the weight of a game, by stratum and pair; {@code pooled} as in {@link RatingFit#of}. */
    static double[][] of(List<Stratum> strata, boolean pooled, Components components) {
        Map<List<Integer>, Integer> numbers = new HashMap<>();
        int[][] pairings = new int[strata.size()][];
        for (int q = 0; q < pairings.length; q++) {
            Stratum stratum = strata.get(q);
            pairings[q] = new int[stratum.pairs()];
            for (int k = 0; k < pairings[q].length; k++) {
                List<Integer> pairing = pooled
                    ? List.of(stratum.bots[stratum.low[k]], stratum.bots[stratum.high[k]])
                    : Arrays.stream(stratum.groups[stratum.group[k]]).boxed().toList();
                pairings[q][k] = numbers.computeIfAbsent(pairing, key -> numbers.size());
            }
        }
        double[] games = new double[numbers.size()];
        long[] clusters = new long[numbers.size()];
        for (int q = 0; q < pairings.length; q++) {
            Stratum stratum = strata.get(q);
            for (int k = 0; k < pairings[q].length; k++) {
                int pairing = pairings[q][k];
                boolean first = k == 0 || pairing != pairings[q][k - 1];
                games[pairing] += stratum.sums[3 * k];
                clusters[pairing] += first && stratum.sums[3 * k] > 0 ? stratum.clusters : 0;
            }
        }
        double scale = Arrays.stream(games).sum() / Arrays.stream(clusters).mapToDouble(PairingWeights::share).sum();
        double[][] weights = new double[pairings.length][];
        for (int q = 0; q < pairings.length; q++) {
            weights[q] = Arrays.stream(pairings[q]).mapToDouble(pairing ->
                games[pairing] > 0 ? scale * share(clusters[pairing]) / games[pairing] : 0).toArray();
        }
        Stratum.each(strata, (q, k, low, high) -> weights[q][k] *= components.together(low, high) ? 1 : 0);
        return weights;
    }

    private static double share(double clusters) {
        return Math.min(1, clusters / RatingFit.WHOLE);
    }
}
