package steward.league.sequential;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.match.TestSize;
import steward.numerics.SplitMix64;

/** Ranges of scores against closed forms, and how often they hold. */
@Execution(ExecutionMode.CONCURRENT)
class ScoreRangeTest {

    @Test
    void whoWonAllHasABoundOnOneSide() {
        // The likelihood of 74 ones is m^74 where the mean is m, so that the range ends at m = exp(-t^2 / 2 / 74), with
        // 1.9930, Student's 97.5% of 73 degrees, from tables.
        ScoreRange won = ScoreRange.of(GsprtTest.counts(2, 0, 0, 0, 0, 74));
        assertEquals(Math.exp(-1.9930 * 1.9930 / 148), won.low(), 2e-4);
        assertEquals(1, won.high(), 1e-9);
        ScoreRange lost = ScoreRange.of(GsprtTest.counts(2, 74, 0, 0, 0, 0));
        assertEquals(1 - won.low(), lost.high(), 1e-6);
        assertEquals(0, lost.low(), 1e-9);
    }

    @Test
    void ofManyEvenGamesItIsTheNormalBar() {
        // 100,000 seeds of two independent games without ties: the deviation of the mean is sqrt(1/8 / 100,000).
        ScoreRange found = ScoreRange.of(GsprtTest.counts(2, 25_000, 0, 50_000, 0, 25_000));
        assertEquals(0.5 + 1.96 * Math.sqrt(0.125 / 100_000), found.high(), 1e-6);
        assertEquals(0.5 - 1.96 * Math.sqrt(0.125 / 100_000), found.low(), 1e-6);
        assertEquals(0.5, ScoreRange.superiority(GsprtTest.counts(2, 25_000, 0, 50_000, 0, 25_000)), 1e-12);
        assertEquals(0.975, ScoreRange.superiority(GsprtTest.counts(2, 24_781, 0, 50_000, 0, 25_219)), 2e-3);
    }

    /** Half the seeds favour either bot: games of a seed go alike, and a range that counts them apart is too narrow. */
    @Test
    @Tag("slow")
    @Tag("sized")
    void rangesHoldWhereSeedsFavourABot() {
        int trials = TestSize.of(1000, 20_000);
        SplitMix64 random = new SplitMix64(31);
        for (int seeds : new int[] {30, 100, 300}) {
            int held = 0;
            for (int trial = 0; trial < trials; trial++) {
                ScoreCounts scores = new ScoreCounts(2);
                for (int seed = 0; seed < seeds; seed++) {
                    double chance = 1 / (1 + Math.pow(10, (random.nextInt(2) == 0 ? -250 : 250) / 400.0));
                    scores.add(((random.nextDouble() < chance ? 1 : 0) + (random.nextDouble() < chance ? 1 : 0)) / 2.0);
                }
                ScoreRange found = ScoreRange.of(scores);
                held += found.low() <= 0.5 && 0.5 <= found.high() ? 1 : 0;
            }
            double share = (double) held / trials;
            String figure = share + " of " + trials + " with " + seeds + " seeds";
            assertTrue(Math.abs(share - 0.95) < 0.007 + 4 * Math.sqrt(0.95 * 0.05 / trials), figure);
        }
    }
}
