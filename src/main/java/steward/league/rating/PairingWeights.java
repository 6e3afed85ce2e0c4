package steward.league.rating;

import java.util.Arrays;
import java.util.List;

/** What a game weighs so that all pairings weigh the same, and all games together their number. */
final class PairingWeights {

    private PairingWeights() {
    }

    /** By stratum and pair; {@code pooled} as in {@link RatingFit#of}. */
    static double[][] of(int bots, List<Stratum> strata, boolean pooled) {
        return pooled ? byPair(bots, strata) : byGroup(strata);
    }

    private static double[][] byGroup(List<Stratum> strata) {
        double[][] weights = new double[strata.size()][];
        double games = 0;
        double shares = 0;
        for (Stratum stratum : strata) {
            games += games(stratum);
            shares += share(stratum.clusters);
        }
        for (int q = 0; q < weights.length; q++) {
            Stratum stratum = strata.get(q);
            weights[q] = new double[stratum.pairs()];
            double own = games(stratum);
            if (own > 0) {
                Arrays.fill(weights[q], games / shares * share(stratum.clusters) / own);
            }
        }
        return weights;
    }

    private static double games(Stratum stratum) {
        double games = 0;
        for (int k = 0; k < stratum.sums.length; k += 3) {
            games += stratum.sums[k];
        }
        return games;
    }

    private static double share(double clusters) {
        return Math.min(1, clusters / RatingFit.WHOLE);
    }

    private static double[][] byPair(int bots, List<Stratum> strata) {
        double[] games = new double[bots * bots];
        double[] clusters = new double[bots * bots];
        Stratum.each(strata, (q, k, low, high) -> {
            games[low * bots + high] += strata.get(q).sums[3 * k];
            clusters[low * bots + high] += strata.get(q).sums[3 * k] > 0 ? strata.get(q).clusters : 0;
        });
        double all = 0;
        double shares = 0;
        for (int k = 0; k < games.length; k++) {
            all += games[k];
            shares += share(clusters[k]);
        }
        double scale = all / shares;
        double[][] weights = new double[strata.size()][];
        for (int q = 0; q < weights.length; q++) {
            weights[q] = new double[strata.get(q).pairs()];
        }
        Stratum.each(strata, (q, k, low, high) -> {
            int pair = low * bots + high;
            weights[q][k] = games[pair] > 0 ? scale * share(clusters[pair]) / games[pair] : 0;
        });
        return weights;
    }
}
