package steward.league.rating;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.league.Season;

/** Bots that lost everything, groups that never met, and bounds between them. */
@Execution(ExecutionMode.CONCURRENT)
class ComponentsTest {

    private final Results results = results();

    private static Results results() {
        return new Results(Season.of("duel", "key", "limits", "rules", 2, false));
    }

    /** Seeds of one game; the first wins so many of them. */
    private static void meet(Results results, int one, int other, int seeds, int won) {
        for (int seed = 0; seed < seeds; seed++) {
            results.addGame(1_000_000L * one + 10_000L * other + seed, new int[] {one, other}, seed < won ? 0 : 1,
                seed < won ? 1 : 0);
        }
    }

    /** Two at 60:40, and a third that loses all: its games change neither ratings nor bars of the two. */
    @Test
    void aBotThatLosesEverythingWidensNoBar() {
        meet(results, 1, 2, 400, 240);
        Ratings alone = Ratings.of(results, List.of(1, 2));
        meet(results, 1, 3, 400, 400);
        meet(results, 2, 3, 400, 400);
        Ratings found = Ratings.of(results, List.of(1, 2, 3));
        assertEquals(400 * Math.log10(1.5) / 2, found.rating(1).elo(), 1e-9);
        assertEquals(alone.rating(1).bar(), found.rating(1).bar(), 1e-9);
        assertEquals(alone.difference(1, 2).bar(), found.difference(1, 2).bar(), 1e-9);
        assertEquals(List.of(List.of(1, 2), List.of(3)), found.components());
        assertTrue(Double.isNaN(found.rating(3).elo()) && !found.rating(3).isOneSided());
        // 400 seeds in a row with each of the two, whatever is known of the other: the product is 0.025.
        double bound = found.difference(2, 3).boundElo();
        assertEquals(Math.log(0.025), -400 * Math.log1p(Math.pow(10, -bound / 400)), 1e-6);
        assertEquals(-bound, found.difference(3, 1).boundElo(), 1e-6);
        assertEquals(800, found.sweptSeeds(2, 3));
    }

    /** The second has not met the third, which lost to the first: it is below at most by the end of an anytime bar. */
    @Test
    void ofTwoThatHaveNotMetTheGamesOfOthersTellLess() {
        meet(results, 1, 2, 400, 240);
        meet(results, 1, 3, 400, 400);
        Ratings found = Ratings.of(results, List.of(1, 2, 3));
        Difference within = found.difference(1, 2);
        // Half of 5% for three bars, half for the seeds.
        double most = 400 * Math.log10(1.5) + within.anytimeBar(0.025 / 3);
        assertEquals(Math.log(0.025 / 2), -400 * Math.log1p(Math.pow(10,
            -(found.difference(2, 3).boundElo() + most) / 400)), 1e-6);
    }

    /** With one draw in 400 games the third is comparable; the bars of the two stay as they were, nearly. */
    @Test
    void aBotThatLosesNearlyEverythingWidensNoBarEither() {
        meet(results, 1, 2, 400, 240);
        meet(results, 1, 3, 400, 400);
        meet(results, 2, 3, 399, 399);
        Ratings before = Ratings.of(results, List.of(1, 2, 3));
        results.addGame(99_999_999L, new int[] {2, 3}, 0, 0);
        Ratings after = Ratings.of(results, List.of(1, 2, 3));
        assertEquals(1, after.components().size());
        assertEquals(before.difference(1, 2).bar(), after.difference(1, 2).bar(), 0.5);
        assertEquals(before.rating(1).bar(), after.rating(1).bar(), 2);
        assertTrue(after.bounded(3).isOneSided() && after.bounded(3).boundElo() < -500);
    }

    @Test
    void groupsThatNeverMetEachHaveTheirOwnZeroAndNothingBetweenThem() {
        meet(results, 1, 2, 100, 60);
        meet(results, 3, 4, 100, 75);
        Ratings found = Ratings.of(results, List.of(1, 2, 3, 4));
        assertEquals(2, found.components().size());
        assertEquals(400 * Math.log10(3) / 2, found.rating(3).elo(), 1e-9);
        assertEquals(Difference.NONE, found.bounded(1, 3));
        assertTrue(Double.isNaN(found.superiority(1, 3)));
        found.ranks().forEach(range -> assertTrue(range.worst() - range.best() >= 2, range::toString));
        LeagueTable table = LeagueTable.of(results, IntStream.rangeClosed(1, 4)
            .mapToObj(version -> new LeagueTable.Entry(version, "bot " + version, false, true)).toList());
        assertEquals(List.of(), table.apart());
    }

    /** n wins of n: nothing was known of the chance before, so that it is above 1/2 with 1 - 1/2^(n + 1). */
    @Test
    void theLikelihoodOfSuperiorityOfWhoWonAllIsThatOfAChanceOfWhichNothingWasKnown() {
        for (int games : new int[] {1, 2, 5, 12}) {
            Results all = results();
            meet(all, 1, 2, games, games);
            Ratings found = Ratings.of(all, List.of(1, 2));
            assertEquals(1 - Math.pow(0.5, games + 1), found.superiority(1, 2), 1e-12);
            assertEquals(Math.pow(0.5, games + 1), found.superiority(2, 1), 1e-12);
            // Surely better at both sides together, with 5%: 1/2^n of at most 0.025.
            assertEquals(games >= 6, found.isUnequal(1, 2, 0.05));
        }
    }

    @Test
    void aCycleConnectsAndAChainDoesNot() {
        Stratum first = new Stratum(1, 0, 1);
        Stratum second = new Stratum(1, 1, 2);
        Stratum back = new Stratum(1, 0, 2);
        List<Stratum> strata = new ArrayList<>(List.of(first, second, back));
        first.add(first.pattern(1, 1, 0), 3);
        second.add(second.pattern(1, 1, 0), 3);
        assertArrayEquals(new int[] {0, 1, 2}, numbers(Components.of(3, strata)));
        back.add(back.pattern(1, 0, 0), 1);
        assertArrayEquals(new int[] {0, 0, 0}, numbers(Components.of(3, strata)));
    }

    private static int[] numbers(Components components) {
        return IntStream.range(0, 3).map(components::of).toArray();
    }

    /** An anchor's rating is as it is given, and bars are those of the differences to it. */
    @Test
    void anAnchorIsTheZero() {
        meet(results, 1, 2, 400, 240);
        meet(results, 2, 3, 400, 220);
        meet(results, 1, 3, 400, 250);
        List<LeagueTable.Entry> entries = IntStream.rangeClosed(1, 3)
            .mapToObj(version -> new LeagueTable.Entry(version, "bot " + version, false, true)).toList();
        LeagueTable table = LeagueTable.of(results, entries, new LeagueTable.Reference(2, 1500, -1));
        Ratings found = table.ratings();
        assertEquals(1500, table.rows().get(1).rating(), 1e-9);
        assertEquals(0, table.rows().get(1).bar(), 1e-9);
        assertEquals(1500 + found.difference(1, 2).elo(), table.rows().get(0).rating(), 1e-9);
        assertEquals(found.difference(1, 2).bar(), table.rows().get(0).bar(), 1e-9);
        assertEquals(2, table.rows().get(0).to());
        LeagueTable against = LeagueTable.of(results, entries, new LeagueTable.Reference(-1, 0, 3));
        assertEquals(found.difference(1, 3), against.rows().get(0).difference());
        LeagueTable above = LeagueTable.of(results, entries);
        assertEquals(found.difference(3, 2), above.rows().get(2).difference());
    }
}
