package steward.league.rating;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.league.Season;

/** Games of one seed between bots that they connect are one observation. */
@Execution(ExecutionMode.CONCURRENT)
class SharedSeedsTest {

    private static Results results() {
        return new Results(Season.of("duel", "key", "limits", "rules", 2, false));
    }

    /** One bot against four; in each seed it wins against all or loses against all. */
    private static double bar(boolean shared) {
        Results results = results();
        for (int seed = 0; seed < 50; seed++) {
            for (int other = 1; other <= 4; other++) {
                int own = shared ? seed : 100 * other + seed;
                int rank = seed % 2;
                results.addGame(own, new int[] {0, other}, rank, 1 - rank);
                results.addGame(own, new int[] {other, 0}, 1 - rank, rank);
            }
        }
        return Ratings.of(results, IntStream.range(0, 5).boxed().toList()).rating(0).bar();
    }

    @Test
    void oneListOfSeedsForFourOpponentsTellsAsMuchAsForOne() {
        // Against four with seeds of their own there are 200 observations; on one list 50, each four times: of its
        // rating the variance is four times as large, the bar twice. Half an observation of the model's variance is
        // mixed in, and Student's t is for 49.5 degrees of freedom, which makes a little difference.
        assertEquals(2, bar(true) / bar(false), 0.06);
    }

    /** All pairs of 250 bots on one seed, 62,250 games: joined one by one they took minutes. */
    @Test
    @Timeout(20)
    @Tag("slow")
    void allPairsOnOneSeedAreJoinedInTime() {
        Results results = results();
        for (int one = 0; one < 250; one++) {
            for (int other = 0; other < one; other++) {
                results.addGame(7, new int[] {one, other}, 0, 1);
                results.addGame(7, new int[] {other, one}, 0, 1);
            }
        }
        assertEquals(1, results.clusters());
        assertEquals(250 * 249 / 2, results.strata(IntStream.range(0, 250).toArray()).get(0).pairs());
    }

    @Test
    void gamesThatConnectTwoClustersMakeThemOne() {
        Results results = results();
        results.addGame(7, new int[] {1, 2}, 0, 1);
        results.addGame(7, new int[] {3, 4}, 0, 1);
        assertEquals(2, results.clusters());
        results.addGame(8, new int[] {1, 2}, 1, 0);
        assertEquals(3, results.clusters());
        results.addGame(7, new int[] {2, 3}, 0, 1);
        assertEquals(2, results.clusters());
        assertEquals(List.of(3, 1), results.strata(1, 2, 3, 4).stream().map(Stratum::pairs).sorted((a, b) -> b - a)
            .toList());
        assertEquals(1, results.strata(3, 4).size());
    }
}
