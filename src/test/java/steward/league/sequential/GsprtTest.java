package steward.league.sequential;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import steward.numerics.SplitMix64;

/** The test against values that others have published, and against closed forms. */
class GsprtTest {

    /** Counts of scores at equal distances from 0 to 1. @param games of an observation */
    static ScoreCounts counts(int games, long... counts) {
        ScoreCounts scores = new ScoreCounts(games);
        for (int k = 0; k < counts.length; k++) {
            scores.add((double) k / (counts.length - 1), counts[k]);
        }
        return scores;
    }

    private static double ratio(double elo0, double elo1, Gsprt.Model model, int games, long... counts) {
        return new Gsprt(elo0, elo1, 0.05, 0.05, model).ratio(counts(games, counts));
    }

    @Test
    void fishtestsOwnExamples() {
        // From the self-test of fishtest's LLRcalc.py, five decimals.
        assertEquals(2.13107, ratio(-3, 1, Gsprt.Model.LOGISTIC, 2, 10789, 19328, 33806, 19402, 10543), 6e-6);
        assertEquals(0.30087, ratio(-3, 1, Gsprt.Model.NORMALIZED, 2, 10789, 19328, 33806, 19402, 10543), 6e-6);
        assertEquals(2.16254, ratio(0.2, 0.9, Gsprt.Model.LOGISTIC, 2, 39, 2226, 31451, 2412, 40), 6e-6);
        assertEquals(2.16294, ratio(0.764, 3.439, Gsprt.Model.NORMALIZED, 2, 39, 2226, 31451, 2412, 40), 6e-6);
    }

    @Test
    void fastchesssExamplesOfSingleGames() {
        // From the tests of fastchess, which give two decimals: losses, draws, wins.
        assertEquals(0.92, ratio(0, 2, Gsprt.Model.NORMALIZED, 1, 36027, 68692, 36433), 0.01);
        assertEquals(2.30, ratio(-1.75, 0.25, Gsprt.Model.NORMALIZED, 1, 10650, 20431, 10871), 0.01);
    }

    @Test
    void examplesOfEnginesInDevelopment() {
        // From the tests of a tool for the game of Tak, which took them from its test server: normalized, two decimals.
        assertEquals(-2.27, ratio(0, 5, Gsprt.Model.NORMALIZED, 2, 440, 2910, 5170, 2888, 455), 0.01);
        assertEquals(2.99, ratio(0, 5, Gsprt.Model.NORMALIZED, 2, 142, 620, 1122, 699, 188), 0.01);
        assertEquals(2.90, ratio(-5, 0, Gsprt.Model.NORMALIZED, 2, 349, 1561, 3340, 1604, 359), 0.01);
        assertEquals(-1.11, ratio(-5, 0, Gsprt.Model.NORMALIZED, 2, 98, 382, 674, 369, 71), 0.01);
    }

    /**
     * Of these counts Newton's first step, the distance of the mean from 1/2 over the mean square of that, is 2: there
     * the chance of the score 0 is infinite. The ratio is that of a bisection of some lines of Python.
     */
    @Test
    void aStepToWhereAChanceIsInfiniteIsNotTakenForTheEnd() {
        assertEquals(2.0110954944236887, ratio(0, 30, Gsprt.Model.LOGISTIC, 2, 1, 1, 11, 11, 6), 1e-12);
    }

    private static int pairsUntilH1(double elo1) {
        Gsprt test = new Gsprt(0, elo1, 0.05, 0.05, Gsprt.Model.NORMALIZED);
        int pairs = 1;
        while (test.state(counts(2, 0, 0, 0, 0, pairs)) == Gsprt.State.OPEN) {
            pairs++;
        }
        return pairs;
    }

    @Test
    void pairsThatAreAllWonEndTheTestAsInFastchess() {
        // Numbers of fastchess; a program of forty lines of Python that maximizes the likelihood by SLSQP has the same.
        assertEquals(74, pairsUntilH1(10));
        assertEquals(17, pairsUntilH1(50));
        assertEquals(8.32495, ratio(0, 20, Gsprt.Model.NORMALIZED, 2, 0, 0, 12, 0, 101), 5e-6);
        assertEquals(10, pairsUntilH1(200), "fewer decide nothing");
    }

    /** Lagrange's conditions: the mean or the t-statistic is the wanted one, and the chances are those of the tilt. */
    @Test
    void constrainedFrequenciesFulfilTheirConditions() {
        SplitMix64 random = new SplitMix64(31);
        double[] scores = {0, 0.25, 0.5, 0.75, 1};
        for (int trial = 0; trial < 2000; trial++) {
            double[] shares = new double[5];
            double all = 0;
            for (int k = 0; k < 5; k++) {
                shares[k] = random.nextInt(3) == 0 ? 1e-3 : 1 + random.nextInt(100);
                all += shares[k];
            }
            for (int k = 0; k < 5; k++) {
                shares[k] /= all;
            }
            double t = (random.nextInt(2001) - 1000) / 1000.0 * (trial % 2 == 0 ? 0.3 : 4);
            double[] found = new ConstrainedFrequencies(scores, shares).ofDeviations(t);
            double mean = 0;
            double sum = 0;
            for (int k = 0; k < 5; k++) {
                mean += found[k] * scores[k];
                sum += found[k];
            }
            double variance = 0;
            for (int k = 0; k < 5; k++) {
                variance += found[k] * (scores[k] - mean) * (scores[k] - mean);
            }
            String which = "trial " + trial + " of seed 31, t " + t;
            assertEquals(1, sum, 1e-6, which);
            assertEquals(t, (mean - 0.5) / Math.sqrt(variance), 1e-6, which);
            double s = 0.1 + random.nextInt(801) / 1000.0;
            double[] tilted = new ConstrainedFrequencies(scores, shares).ofMean(s);
            double reached = 0;
            for (int k = 0; k < 5; k++) {
                reached += tilted[k] * scores[k];
            }
            assertEquals(s, reached, 1e-9, which);
        }
    }

    @Test
    void aFewSeedsThatAreAlikeDecideNothing() {
        Gsprt test = new Gsprt(0, 20, 0.05, 0.05, Gsprt.Model.LOGISTIC);
        assertEquals(Gsprt.State.OPEN, test.state(counts(2, 0, 0, 12, 0, 0)));
        assertEquals(Gsprt.State.OPEN, test.state(counts(2, 0, 0, 0, 0, 5)));
        assertEquals(Gsprt.State.OPEN, test.state(new ScoreCounts(2)));
        assertEquals(Gsprt.State.H1, test.state(counts(2, 0, 0, 0, 0, 100)));
        assertEquals(Gsprt.State.H0, test.state(counts(2, 100, 0, 0, 0, 0)));
    }

    @Test
    void boundsAreWalds() {
        Gsprt test = new Gsprt(0, 5, 0.05, 0.1, Gsprt.Model.NORMALIZED);
        assertEquals(Math.log(0.1 / 0.95), test.lower(), 1e-12);
        assertEquals(Math.log(0.9 / 0.05), test.upper(), 1e-12);
        for (double[] wrong : new double[][] {{5, 0, 0.1, 0.1}, {0, 0, 0.1, 0.1}, {0, 5, 0, 0.1}, {0, 5, 0.1, 0.5},
            {0, 5, Double.NaN, 0.1}}) {
            assertThrows(IllegalArgumentException.class,
                () -> new Gsprt(wrong[0], wrong[1], wrong[2], wrong[3], Gsprt.Model.LOGISTIC));
        }
    }

    @Test
    void eloOfAScore() {
        // A score of 3/4 is 190.85 logistic Elo; in games that are won or lost independently the deviation of the
        // mean of two is sqrt(3/16 / 2), that of one sqrt(3/16), so that 1/4 above even is 0.577 deviations of a game.
        // So many are far beyond the bound: their number was fixed.
        ScoreCounts scores = counts(2, 62_500, 0, 375_000, 0, 562_500);
        Gsprt logistic = new Gsprt(0, 5, 0.05, 0.05, Gsprt.Model.LOGISTIC);
        Gsprt normalized = new Gsprt(0, 5, 0.05, 0.05, Gsprt.Model.NORMALIZED);
        assertEquals(400 * Math.log10(3), logistic.range(scores).elo(), 0.01);
        assertEquals(0.25 / Math.sqrt(3.0 / 16) * 800 / Math.log(10), normalized.range(scores).elo(), 0.01);
    }

    /** Observations in proportion to a true distribution with three cells and this mean, as many as a long holds. */
    private static ScoreCounts inProportion(double mean) {
        long all = 1L << 50;
        long ends = all / 4;
        long shift = Math.round((mean - 0.5) * all);
        return counts(2, ends - shift, 0, all - 2 * ends, 0, ends + shift);
    }

    @Test
    void theExpectedLengthIsWaldsWhereStepsAreSmall() {
        // Without overshoot, from the middle: at H1 the chance is 1 - beta and the length Wald's
        // ((1 - beta) b + beta a) / drift, with the drift (t1 - t0)^2 / 2. The deviation of a half at 0 or 1 is
        // sqrt(1/8).
        Gsprt test = new Gsprt(0, 0.5, 0.05, 0.05, Gsprt.Model.NORMALIZED);
        double deviation = Math.sqrt(0.125);
        double t1 = 0.5 / (800 / Math.log(10)) * Math.sqrt(2);
        ExpectedLength found = ExpectedLength.of(test, inProportion(0.5 + t1 * deviation), 0);
        assertEquals(0.95, found.chance(), 1e-3);
        assertEquals((0.95 * Math.log(19) - 0.05 * Math.log(19)) / (t1 * t1 / 2) / found.observations(), 1, 2e-3);
        ExpectedLength middle = ExpectedLength.of(test, inProportion(0.5 + t1 / 2 * deviation), 0);
        assertEquals(0.5, middle.chance(), 1e-4);
        assertTrue(middle.observations() > found.observations());
        ExpectedLength left = ExpectedLength.of(test, inProportion(0.5 + t1 * deviation), 2.9);
        assertTrue(left.observations() < found.observations() / 10);
    }

    @Test
    void theExpectedLengthOfAlikeObservationsIsTheirNumber() {
        // 74 pairs as above; 20 of them have been played.
        Gsprt test = new Gsprt(0, 10, 0.05, 0.05, Gsprt.Model.NORMALIZED);
        ScoreCounts scores = counts(2, 0, 0, 0, 0, 20);
        assertEquals(54, ExpectedLength.of(test, scores, test.ratio(scores)).observations(), 2);
    }
}
