package steward.league.promise;

import java.util.stream.LongStream;
import steward.league.rating.RatingFit;
import steward.league.sequential.ExpectedLength;
import steward.league.sequential.Gsprt;
import steward.league.sequential.ScoreCounts;
import steward.league.sequential.StoppedRange;
import steward.numerics.SplitMix64;

/**
 * Errors and lengths of sequential tests.
 *
 * @param accepted share of the tests that accepted H1
 * @param mean     observations until they ended
 * @param theory   what is expected of them
 * @param held     share of the tests at whose end the truth was in the range
 */
record PlayedTests(double accepted, double mean, double theory, double held) {

    private static final long SEED = 21;

    /**
     * Plays.
     *
     * @param at    the true difference, in the test's Elo
     * @param alike observations at the beginning that are even, as of bots that have not yet met a seed that matters
     */
    static PlayedTests of(Gsprt test, long tests, double at, double drawn, double push, int alike) {
        MadeUpGroup group = group(BestAllocation.bound(-10, 10,
            apart -> elo(test.model(), truth(group(apart, drawn, push))) < at), drawn, push);
        double[] scores = group.scores();
        long[] sums = LongStream.range(0, tests).parallel().mapToObj(number -> {
            SplitMix64 random = new SplitMix64(SEED + number);
            ScoreCounts counted = new ScoreCounts(2);
            counted.add(0.5, alike);
            Gsprt.State state = Gsprt.State.OPEN;
            while (state == Gsprt.State.OPEN) {
                for (int step = steps(test, counted); step > 0; step--) {
                    counted.add(scores[group.draw(random)]);
                }
                state = test.state(counted);
            }
            StoppedRange range = test.range(counted);
            return new long[] {state == Gsprt.State.H1 ? 1 : 0, counted.observations(),
                range.low() <= at && at <= range.high() ? 1 : 0};
        }).reduce(PlayedLeagues::sum).orElseThrow();
        return new PlayedTests((double) sums[0] / tests, (double) sums[1] / tests,
            ExpectedLength.of(test, truth(group), 0).observations(), (double) sums[2] / tests);
    }

    /** Observations that surely decide nothing, and one: half of those that are needed if all go one way. */
    private static int steps(Gsprt test, ScoreCounts counted) {
        double ratio = test.ratio(counted);
        return counted.observations() < Gsprt.LEAST ? 1 : 1 + (int) (Math.min(test.upper() - ratio,
            ratio - test.lower()) / 2 / test.greatestStep(counted));
    }

    private static MadeUpGroup group(double apart, double drawn, double push) {
        return MadeUpGroup.pairs(new double[] {apart}, drawn, 0, push / RatingFit.ELO, new int[] {0, 1});
    }

    /** Scores as often as is to be expected. */
    private static ScoreCounts truth(MadeUpGroup group) {
        double[] scores = group.scores();
        ScoreCounts truth = new ScoreCounts(2);
        for (int way = 0; way < scores.length; way++) {
            truth.add(scores[way], Math.round(group.chances()[way] * 0x1p40));
        }
        return truth;
    }

    private static double elo(Gsprt.Model model, ScoreCounts truth) {
        double score = truth.mean();
        return model == Gsprt.Model.LOGISTIC ? 400 * StrictMath.log10(score / (1 - score))
            : (score - 0.5) / Math.sqrt(truth.variance() * 2) * 800 / StrictMath.log(10);
    }
}
