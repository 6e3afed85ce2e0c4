package steward.league.rating;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.match.TestSize;

/** Bounds of bots that have won or lost nearly everything. */
@Execution(ExecutionMode.CONCURRENT)
class ScoreTestTest {

    private static RatingFit two(int wins, int losses) {
        Stratum stratum = new Stratum(1, 0, 1);
        stratum.add(stratum.pattern(1, 1, 0), wins);
        stratum.add(stratum.pattern(1, 0, 0), losses);
        return RatingFit.of(2, List.of(stratum), false);
    }

    @Test
    void whoHasWonEverythingIsAheadByAsMuchAsTheExactBoundSays() {
        // The exact bound of n wins of n is the chance p with p^n = 0.025 (C. J. Clopper and E. S. Pearson, 1934).
        for (int games : new int[] {50, 200, 1000}) {
            double chance = Math.pow(0.025, 1.0 / games);
            Difference found = new ScoreTest(two(games, 0)).bounded(0, 1);
            assertTrue(found.isOneSided());
            assertEquals(400 * Math.log10(chance / (1 - chance)), found.boundElo(), 25, games + " games");
            assertEquals(-found.boundElo(), new ScoreTest(two(games, 0)).bounded(1, 0).boundElo(), 0.5);
        }
        assertFalse(new ScoreTest(two(50, 50)).bounded(0, 1).isOneSided());
    }

    @Test
    void ofAFewWinsABoundLeavesTheOtherSignAndClaimsNoMoreThanTheExactOne() {
        for (int games = 1; games <= 20; games++) {
            double chance = Math.pow(0.025, 1.0 / games);
            double exact = 400 * Math.log10(chance / (1 - chance));
            Difference found = new ScoreTest(two(games, 0)).bounded(0, 1);
            assertTrue(found.isOneSided() ? found.boundElo() < exact + 50 : !Difference.isKnown(found.bar()),
                games + " games: " + found.boundElo() + " of " + exact);
            assertTrue(games > 4 || !found.isOneSided() || found.boundElo() < 0, games + " games");
        }
    }

    /** The games of 2 to 4 wins leave 616 Elo and more on the wrong side: that is beyond 3 in natural units. */
    @Test
    void aBoundFarOnTheWrongSideIsLeftOut() {
        for (int games = 2; games <= 4; games++) {
            Difference found = new ScoreTest(two(games, 0)).bounded(0, 1);
            assertTrue(!found.isOneSided() && !Difference.isKnown(found.bar()), games + " games: " + found.boundElo());
        }
        assertTrue(new ScoreTest(two(5, 0)).bounded(0, 1).isOneSided());
    }

    /** Two that lost every game against a third are not told apart: neither is surely the better one. */
    @Test
    void twoThatLostAllToAThirdAreNotToldApart() {
        for (int games = 1; games <= 40; games += 3) {
            Stratum one = new Stratum(1, 0, 1);
            one.add(one.pattern(1, 1, 0), games);
            Stratum other = new Stratum(1, 0, 2);
            other.add(other.pattern(1, 1, 0), 2 * games);
            Difference found = new ScoreTest(RatingFit.of(3, List.of(one, other), false)).bounded(1, 2);
            assertTrue(!found.isOneSided() && !Difference.isKnown(found.bar())
                || found.boundElo() * found.value() < 0, games + " games: " + found);
        }
    }

    /** In a table of 40 the others are held; its bound holds for at least 95% of leagues, too. */
    @Test
    @Tag("slow")
    @Tag("sized")
    void theBoundOfABotAheadOfAFieldHolds() {
        int bots = 40;
        int leagues = TestSize.of(80, 1000);
        double elo = 800;
        int held = 0;
        for (int league = 0; league < leagues; league++) {
            SplittableRandom random = new SplittableRandom(league);
            List<Stratum> strata = new ArrayList<>();
            for (int i = 0; i < bots; i++) {
                for (int j = i + 1; j < bots; j++) {
                    double chance = 1 / (1 + Math.pow(10, (i == 0 ? -elo : 0) / 400));
                    Stratum stratum = new Stratum(1, i, j);
                    int[] patterns = {stratum.pattern(1, 0, 0), stratum.pattern(1, 1, 0)};
                    for (int game = 0; game < 6; game++) {
                        stratum.add(patterns[random.nextDouble() < chance ? 1 : 0], 1);
                    }
                    strata.add(stratum);
                }
            }
            double[] mean = new double[bots];
            Arrays.fill(mean, 1.0 / bots);
            Difference found = new ScoreTest(RatingFit.of(bots, strata, false)).boundedToMean(0, mean);
            assertTrue(found.isOneSided() && found.boundElo() > 400, found::toString);
            held += found.holds(elo - elo / bots) ? 1 : 0;
        }
        assertTrue(held >= 0.95 * leagues, held + " of " + leagues);
    }
}
