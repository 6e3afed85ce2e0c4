package steward.lab.statistics;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import steward.league.rating.RankRange;
import steward.league.rating.RatingFit;
import steward.league.rating.ScoreTest;
import steward.league.rating.Stratum;
import steward.numerics.SplitMix64;

/**
 * Bars at a fixed number of clusters.
 *
 * @param clusters of each group
 */
record FixedCheck(MadeUpLeague league, int... clusters) {

    /** In Elo: what is left of no difference by rounding. */
    private static final double EQUAL = 1e-6;

    /** Returns a check with equally many clusters of each group. */
    static FixedCheck even(MadeUpLeague league, int clusters) {
        return new FixedCheck(league, IntStream.generate(() -> clusters).limit(league.groups().size()).toArray());
    }

    /**
     * Result of a check.
     *
     * @param bars  how often those of differences held
     * @param ranks how often the range of a bot had all ranks that it shares; that of the bot where it was least often
     */
    record Outcome(Coverage bars, double ranks) { }

    Outcome run(int threads, long leagues, long seed) throws InterruptedException {
        int bots = league.bots();
        int pairs = bots * (bots - 1) / 2;
        RankRange[] ranks = ranks();
        long[] held = Counted.play(threads, leagues, pairs + bots, () -> {
            List<Stratum> strata = league.groups().stream().map(MadeUpGroup::stratum).toList();
            return (number, counts) -> play(new SplitMix64(seed + number), strata, ranks, counts);
        });
        double least = 1;
        for (int bot = 0; bot < bots; bot++) {
            least = Math.min(least, (double) held[pairs + bot] / leagues);
        }
        return new Outcome(Coverage.of(league, leagues, Arrays.copyOf(held, pairs)), least);
    }

    /** The true ranks: bots that are equal share all of theirs. */
    private RankRange[] ranks() {
        RankRange[] ranks = new RankRange[league.bots()];
        for (int bot = 0; bot < ranks.length; bot++) {
            int better = 0;
            int worse = 0;
            for (int other = 0; other < ranks.length; other++) {
                double apart = league.truth().rating(other) - league.truth().rating(bot);
                better += apart > EQUAL ? 1 : 0;
                worse += apart < -EQUAL ? 1 : 0;
            }
            ranks[bot] = new RankRange(1 + better, ranks.length - worse);
        }
        return ranks;
    }

    private void play(SplitMix64 random, List<Stratum> strata, RankRange[] ranks, long... counts) {
        for (int q = 0; q < clusters.length; q++) {
            Stratum stratum = strata.get(q);
            stratum.clear();
            MadeUpGroup group = league.groups().get(q);
            for (int k = 0; k < clusters[q]; k++) {
                stratum.add(group.draw(random), 1);
            }
        }
        RatingFit fit = RatingFit.of(league.bots(), strata, league.pooled(), league.truth());
        ScoreTest test = new ScoreTest(fit);
        int pair = 0;
        for (int i = 0; i < league.bots(); i++) {
            for (int j = i + 1; j < league.bots(); j++) {
                double truth = league.truth().rating(i) - league.truth().rating(j);
                counts[pair++] += test.bounded(i, j).holds(truth) ? 1 : 0;
            }
        }
        RankRange[] all = RankRange.all(fit);
        for (RankRange truth : ranks) {
            RankRange found = all[pair - counts.length + league.bots()];
            counts[pair++] += found.best() <= truth.best() && found.worst() >= truth.worst() ? 1 : 0;
        }
    }
}
