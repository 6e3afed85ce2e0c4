package steward.league.pairing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.league.Season;
import steward.league.rating.Ratings;
import steward.league.rating.Results;

/** Who is waited for until bars are narrow, and for how many games. */
@Execution(ExecutionMode.CONCURRENT)
class BarNeedTest {

    private final Results results = new Results(Season.of("duel", "key", "limits", "rules", 2, false));
    private long seed;

    /** Seeds of one game; the first wins so many of them. */
    private BarNeedTest meet(int one, int other, int seeds, int won) {
        for (int k = 0; k < seeds; k++) {
            results.addGame(seed++, new int[] {one, other}, k < won ? 0 : 1, k < won ? 1 : 0);
        }
        return this;
    }

    private Ratings ratings(Integer... versions) {
        return Ratings.of(results, List.of(versions));
    }

    private boolean isMet(double bars, Integer... versions) {
        return new StopRule(bars, false, StopRule.USUAL_EQUAL).isMet(ratings(versions), (one, other) -> true);
    }

    /** Bars shrink as the root of the games: with as many as were told they are as wide as was asked, nearly. */
    @Test
    void withTheGamesThatWereToldBarsAreAsWideAsWasAsked() {
        meet(1, 2, 200, 110).meet(2, 3, 200, 120).meet(1, 3, 200, 124);
        for (BarNeed need : BarNeed.of(ratings(1, 2, 3), 20)) {
            assertTrue(need.isWaitedFor() && need.games() == 400, need::toString);
            BarNeedTest longer = new BarNeedTest();
            int times = (int) Math.round(need.needed() / need.games());
            longer.meet(1, 2, 200 * times, 110 * times).meet(2, 3, 200 * times, 120 * times)
                .meet(1, 3, 200 * times, 124 * times);
            assertEquals(20, longer.ratings(1, 2, 3).rating(need.version()).anytimeBar(), 2);
        }
        // Even bots without draws, counted beforehand.
        int even = (int) Math.round(BarNeed.even(3, 20) / 2);
        BarNeedTest all = new BarNeedTest().meet(1, 2, even, even / 2).meet(2, 3, even, even / 2)
            .meet(1, 3, even, even / 2);
        assertEquals(20, all.ratings(1, 2, 3).rating(1).anytimeBar(), 0.2);
    }

    /** A third that loses everything is waited for until it has the games of an even bot, and no longer. */
    @Test
    void aBotThatLosesEverythingEndsNoLeagueLate() {
        int even = (int) Math.ceil(BarNeed.even(3, 50));
        meet(1, 2, even, even / 2).meet(1, 3, even / 2 - 2, even / 2 - 2).meet(2, 3, even / 2 - 2, even / 2 - 2);
        assertTrue(BarNeed.of(ratings(1, 2, 3), 50).get(2).isWaitedFor());
        assertFalse(isMet(50, 1, 2, 3));
        meet(1, 3, 6, 6);
        assertTrue(BarNeed.of(ratings(1, 2, 3), 50).get(2).isBeyondReach());
        assertTrue(isMet(50, 1, 2, 3));
    }

    @Test
    void groupsThatNeverMetEndWhenEachIsNarrow() {
        int even = (int) Math.ceil(BarNeed.even(4, 50));
        meet(1, 2, even, even / 2).meet(3, 4, even / 4, even / 8);
        assertFalse(isMet(50, 1, 2, 3, 4));
        meet(3, 4, even, even / 2);
        assertTrue(isMet(50, 1, 2, 3, 4));
    }

    /** A bot without games has no bar, and the games of an even bot before it. */
    @Test
    void whoHasNotPlayedNeedsTheGamesOfAnEvenBot() {
        meet(1, 2, 100, 50);
        BarNeed need = BarNeed.of(ratings(1, 2, 3), 50).get(2);
        assertEquals(3, need.version());
        assertEquals(BarNeed.even(3, 50), need.needed());
        assertTrue(need.isWaitedFor() && Double.isNaN(need.bar()));
    }
}
