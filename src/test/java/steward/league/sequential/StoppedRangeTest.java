package steward.league.sequential;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Locale;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.match.TestSize;
import steward.numerics.SplitMix64;

/** Ranges corrected for stopping: another program's, how they go with the verdict, and how often they hold. */
@Execution(ExecutionMode.CONCURRENT)
class StoppedRangeTest {

    private static ScoreCounts counts(long... counts) {
        ScoreCounts scores = new ScoreCounts(2);
        for (int k = 0; k < counts.length; k++) {
            scores.add(k / 4.0, counts[k]);
        }
        return scores;
    }

    private static void like(StoppedRange found, double low, double elo, double high, double superiority) {
        assertEquals(low, found.low(), 0.03);
        assertEquals(elo, found.elo(), 0.03);
        assertEquals(high, found.high(), 0.03);
        assertEquals(superiority, found.superiority(), 5e-4);
    }

    /** From fishtest's sprt.py, analytics(p=0.1), in logistic Elo; its LLR is an approximation. */
    @Test
    void fishtestTellsTheSameOfTestsThatAreOver() {
        like(new Gsprt(0, 3.58, 0.05, 0.05, Gsprt.Model.LOGISTIC).range(counts(440, 2910, 5170, 2888, 455)),
            -1.7832457441115876, 0.6957414374397095, 3.310601790756042, 0.6759841809088467);
        StoppedRange normalized = new Gsprt(0, 5, 0.05, 0.05, Gsprt.Model.NORMALIZED)
            .range(counts(142, 620, 1122, 699, 188));
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

    /** 90% with alpha = beta = 0.05, at both hypotheses and between; beyond them at least so much. */
    @Test
    @Tag("slow")
    @Tag("sized")
    void rangesHoldInNineOfTenTests(TestReporter reporter) {
        int trials = TestSize.of(100, 4000);
        for (Gsprt.Model model : Gsprt.Model.values()) {
            Gsprt test = new Gsprt(0, 30, 0.05, 0.05, model);
            for (double mean : TestSize.isWhole() ? new double[] {0.46, 0.5, 0.52, 0.54, 0.6, 0.7}
                    : new double[] {0.5, 0.6}) {
                SplitMix64 random = new SplitMix64(17);
                double draws = 0.3;
                // The square of the points is on average 1 for a game won, 1/4 for one drawn.
                double variance = mean - draws / 4 - mean * mean;
                double truth = model == Gsprt.Model.LOGISTIC ? 400 * Math.log10(mean / (1 - mean))
                    : (mean - 0.5) / Math.sqrt(variance) * 800 / Math.log(10);
                int held = 0;
                for (int trial = 0; trial < trials; trial++) {
                    StoppedRange found = test.range(played(test, random, mean, draws, Integer.MAX_VALUE));
                    held += found.low() <= truth && truth <= found.high() ? 1 : 0;
                }
                double share = (double) held / trials;
                String figure = String.format(Locale.ROOT, "%s, mean score %.2f: held in %.4f of %d tests of seed 17",
                    model, mean, share, trials);
                reporter.publishEntry("range", figure);
                double most = mean >= 0.5 && mean <= 0.54 ? 0.92 : 1;
                assertTrue(share > 0.88 - 4 * Math.sqrt(0.09 / trials)
                    && share < most + 4 * Math.sqrt(0.09 / trials), figure);
            }
        }
    }
}
