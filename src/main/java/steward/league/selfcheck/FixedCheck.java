package steward.league.selfcheck;

import java.util.List;
import java.util.stream.IntStream;
import steward.league.rating.Difference;
import steward.league.rating.RatingFit;
import steward.league.rating.Stratum;
import steward.numerics.SplitMix64;

/**
 * Bars at a fixed number of clusters.
 *
 * @param league   the bots
 * @param clusters of each group
 */
record FixedCheck(MadeUpLeague league, int... clusters) {

    /** The same number of all groups. */
    static FixedCheck even(MadeUpLeague league, int clusters) {
        return new FixedCheck(league, IntStream.generate(() -> clusters).limit(league.groups().size()).toArray());
    }

    Coverage run(int threads, long leagues, long seed) throws InterruptedException {
        int bots = league.bots();
        long[] inside = Counted.play(threads, leagues, bots * (bots - 1) / 2, () -> {
            List<Stratum> strata = league.groups().stream().map(MadeUpGroup::stratum).toList();
            return (number, counts) -> play(new SplitMix64(seed + number), strata, counts);
        });
        return Coverage.of(league, leagues, inside);
    }

    private void play(SplitMix64 random, List<Stratum> strata, long... counts) {
        for (int q = 0; q < clusters.length; q++) {
            Stratum stratum = strata.get(q);
            stratum.clear();
            MadeUpGroup group = league.groups().get(q);
            for (int k = 0; k < clusters[q]; k++) {
                stratum.add(group.draw(random), 1);
            }
        }
        RatingFit fit = RatingFit.of(league.bots(), strata, league.pooled(), league.truth());
        int pair = 0;
        for (int i = 0; i < league.bots(); i++) {
            for (int j = i + 1; j < league.bots(); j++) {
                Difference found = fit.difference(i, j);
                double truth = league.truth().rating(i) - league.truth().rating(j);
                counts[pair++] += Math.abs(found.elo() - truth) <= found.bar() ? 1 : 0;
            }
        }
    }
}
