package steward.league.rating;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
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
        for (int games : new int[] {3, 5, 50, 200, 1000}) {
            double chance = Math.pow(0.025, 1.0 / games);
            Difference found = new ScoreTest(two(games, 0)).bounded(0, 1);
            assertTrue(found.isOneSided());
            assertEquals(400 * Math.log10(chance / (1 - chance)), found.boundElo(), 1e-6, games + " games");
            assertEquals(-found.boundElo(), new ScoreTest(two(games, 0)).bounded(1, 0).boundElo(), 1e-6);
        }
        assertFalse(new ScoreTest(two(50, 50)).bounded(0, 1).isOneSided());
    }

    /** One win leaves 636 Elo on the wrong side: that is beyond 3 in natural units, and says nothing. */
    @Test
    void aBoundFarOnTheWrongSideIsLeftOut() {
        Difference found = new ScoreTest(two(1, 0)).bounded(0, 1);
        assertTrue(!found.isOneSided() && !Difference.isKnown(found.bar()), found::toString);
    }

    /** Two that lost every game against a third are not told apart: nothing is known of them. */
    @Test
    void twoThatLostAllToAThirdAreNotToldApart() {
        for (int games = 1; games <= 40; games += 3) {
            Stratum one = new Stratum(1, 0, 1);
            one.add(one.pattern(1, 1, 0), games);
            Stratum other = new Stratum(1, 0, 2);
            other.add(other.pattern(1, 1, 0), 2 * games);
            RatingFit fit = RatingFit.of(3, List.of(one, other), false);
            assertEquals(Difference.NONE, new ScoreTest(fit).bounded(1, 2), games + " games");
            assertTrue(Double.isNaN(fit.sweeps().superiority(1, 2)));
        }
    }

    /** Half a point of 100 games connects them: then the score test tells a bound, near to the exact one. */
    @Test
    void whoHasWonNearlyEverythingHasABoundToo() {
        Difference found = new ScoreTest(two(199, 1)).bounded(0, 1);
        // The chance of which 199 or more of 200 come with 2.5%: p^200 + 200 p^199 (1 - p).
        double low = 0.9;
        double high = 1;
        for (int k = 0; k < 100; k++) {
            double p = (low + high) / 2;
            boolean over = Math.pow(p, 200) + 200 * Math.pow(p, 199) * (1 - p) > 0.025;
            low = over ? low : p;
            high = over ? p : high;
        }
        assertTrue(found.isOneSided());
        assertEquals(400 * Math.log10(low / (1 - low)), found.boundElo(), 25);
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
            RatingFit fit = RatingFit.of(bots, strata, false);
            if (fit.components().isAlone(0)) {
                held++;
                continue;
            }
            Difference found = new ScoreTest(fit).boundedToMean(0);
            assertTrue(found.isOneSided() && found.boundElo() > 400, found::toString);
            held += found.holds(elo - elo * fit.meanWeights(0)[0]) ? 1 : 0;
        }
        assertTrue(held >= 0.95 * leagues, held + " of " + leagues);
    }
}
