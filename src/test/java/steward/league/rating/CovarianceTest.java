package steward.league.rating;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.league.Season;

/** All differences of a table at once, against each by itself: one sum over all pairings for every pair. */
@Execution(ExecutionMode.CONCURRENT)
class CovarianceTest {

    /** Games of bots who meet by lot, some on a few seeds that many share. */
    private static RatingFit fit(long number) {
        SplittableRandom random = new SplittableRandom(number);
        int players = 2 + random.nextInt(2);
        int bots = players + random.nextInt(12);
        int seeds = number % 3 == 0 ? 15 : Integer.MAX_VALUE;
        Results results = new Results(Season.of("duel", "key", "limits", "rules", players, false));
        for (int game = 0; game < 40 * bots; game++) {
            int[] lineup = new int[players];
            Arrays.setAll(lineup, seat -> seat);
            for (int seat = 0; seat < players; seat++) {
                int drawn = random.nextInt(bots);
                int place = IntStream.of(lineup).boxed().toList().indexOf(drawn);
                lineup[place < 0 ? seat : place] = place < 0 ? drawn : lineup[seat];
                lineup[seat] = drawn;
            }
            int[] ranks = IntStream.of(lineup).map(bot -> random.nextInt(2 + bot)).toArray();
            results.addGame(random.nextInt(seeds), lineup, ranks);
        }
        return RatingFit.of(bots, results.strata(IntStream.range(0, bots).toArray()), false);
    }

    @Test
    @Tag("slow")
    void variancesAndRanksAreThoseThatPairsHaveOneByOne() {
        for (long number = 0; number < 60; number++) {
            RatingFit fit = fit(number);
            double z = Normal.above(0.025 / (fit.bots() - 1));
            RankRange[] ranks = RankRange.all(fit);
            for (int one = 0; one < fit.bots(); one++) {
                List<Integer> above = new ArrayList<>();
                List<Integer> below = new ArrayList<>();
                for (int other = 0; other < fit.bots(); other++) {
                    Difference plain = one == other ? null : fit.difference(one, other);
                    if (plain != null) {
                        String where = "case " + number + ": " + one + ", " + other;
                        assertEquals(plain.variance(), fit.covariance().variance(one, other),
                            1e-9 * plain.variance(), where);
                        assertTrue(fit.covariance().leastFreedom(one, other) <= plain.freedom() * (1 + 1e-9), where);
                        if (Math.abs(plain.elo()) > plain.bar(z)) {
                            (plain.elo() > 0 ? below : above).add(other);
                        }
                    }
                }
                assertEquals(new RankRange(1 + above.size(), fit.bots() - below.size()), ranks[one],
                    "case " + number + ", bot " + one);
            }
        }
    }
}
