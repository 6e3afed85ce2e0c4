package steward.league.sequential;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.numerics.SplitMix64;

/** Ranges corrected for stopping: another program's, and how they go with the verdict. */
@Execution(ExecutionMode.CONCURRENT)
class StoppedRangeTest {

    private static void like(StoppedRange found, double low, double elo, double high, double superiority) {
        assertEquals(low, found.low(), 0.03);
        assertEquals(elo, found.elo(), 0.03);
        assertEquals(high, found.high(), 0.03);
        assertEquals(superiority, found.superiority(), 5e-4);
    }

    /** From fishtest's sprt.py, analytics(p=0.1), in logistic Elo; its LLR is an approximation. */
    @Test
    void fishtestTellsTheSameOfTestsThatAreOver() {
        like(new Gsprt(0, 3.58, 0.05, 0.05, Gsprt.Model.LOGISTIC).range(
            GsprtTest.counts(2, 440, 2910, 5170, 2888, 455)),
            -1.7832457441115876, 0.6957414374397095, 3.310601790756042, 0.6759841809088467);
        StoppedRange normalized = new Gsprt(0, 5, 0.05, 0.05, Gsprt.Model.NORMALIZED)
            .range(GsprtTest.counts(2, 142, 620, 1122, 699, 188));
        assertEquals(4.7045717396038595, Gsprt.logistic(normalized.scoreLow()), 0.05);
        assertEquals(15.55805825471193, Gsprt.logistic(normalized.scoreHigh()), 0.05);
        assertEquals(0.9988696656713245, normalized.superiority(), 5e-4);
    }

    /** A test played to its end, or to a number of seeds. */
    private static ScoreCounts played(Gsprt test, SplitMix64 random, double mean, double draws, int most) {
        ScoreCounts scores = new ScoreCounts(2);
        while (scores.observations() < most && test.state(scores) == Gsprt.State.OPEN) {
            // Observations that surely decide nothing, and one: half of those that are needed if all go one way.
            double ratio = test.ratio(scores);
            int steps = scores.observations() < Gsprt.LEAST ? 1 : 1 + (int) (Math.min(test.upper() - ratio,
                ratio - test.lower()) / 2 / test.greatestStep(scores));
            for (int step = 0; step < steps; step++) {
                double points = 0;
                for (int game = 0; game < 2; game++) {
                    double drawn = random.nextDouble();
                    points += drawn < draws ? 0.5 : random.nextDouble() < 0.5 + (mean - 0.5) / (1 - draws) ? 1 : 0;
                }
                scores.add(points / 2);
            }
        }
        return scores;
    }

    @Test
    @Tag("slow")
    void theRangeIsAboveElo0ExactlyIfH1WasAcceptedAndBelowElo1ExactlyIfH0Was() {
        SplitMix64 random = new SplitMix64(5);
        int[] seen = new int[3];
        for (int trial = 0; trial < 200; trial++) {
            double[] errors = {0.05, 0.01, 0.1};
            Gsprt test = new Gsprt(random.nextInt(30) - 20, 15 + random.nextInt(40), errors[trial % 3],
                errors[random.nextInt(3)], Gsprt.Model.values()[trial % 2]);
            ScoreCounts scores = played(test, random, 0.4 + 0.2 * random.nextDouble(), 0.5 * random.nextDouble(),
                20 + random.nextInt(2000));
            StoppedRange found = test.range(scores);
            Gsprt.State state = test.state(scores);
            seen[state.ordinal()]++;
            String what = test + " " + scores.counts() + " " + found;
            assertEquals(state == Gsprt.State.H1, found.low() > test.elo0(), what);
            assertEquals(state == Gsprt.State.H0, found.high() < test.elo1(), what);
            assertTrue(found.low() <= found.elo() && found.elo() <= found.high(), what);
            assertTrue(state != Gsprt.State.H1 || test.elo0() < 0 || found.superiority() >= 1 - test.alpha(), what);
        }
        assertTrue(seen[0] > 15 && seen[1] > 15 && seen[2] > 15, () -> seen[0] + " " + seen[1] + " " + seen[2]);
    }
}
