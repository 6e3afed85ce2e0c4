package steward.league.selfcheck;

import steward.league.rating.RatingFit;
import steward.league.sequential.ExpectedLength;
import steward.league.sequential.Gsprt;
import steward.league.sequential.ScoreCounts;
import steward.numerics.SplitMix64;

/**
 * Errors and lengths of sequential tests.
 *
 * @param test  the test
 * @param at    what the true difference is, in the test's Elo
 * @param ties  weight of ties
 * @param push  what a seed is worth to one of the two, in Elo
 */
record SprtCheck(Gsprt test, double at, double ties, double push) {

    private static final long LONGEST = 10_000_000;
    private static final int HALVINGS = 60;

    /**
     * What came out.
     *
     * @param accepted share of the tests that accepted H1
     * @param mean     observations until they ended
     * @param theory   what was expected
     */
    record Outcome(double accepted, double mean, ExpectedLength theory) {
    }

    private MadeUpGroup group(double difference) {
        return MadeUpGroup.two(difference, ties, 0, push / RatingFit.ELO, 0, 1);
    }

    private double elo(MadeUpGroup group) {
        return test.model() == Gsprt.Model.NORMALIZED
            ? (group.share() - 0.5) / Math.sqrt(group.variance() * 2) * 800 / StrictMath.log(10)
            : 400 / StrictMath.log(10) * StrictMath.log(group.share() / (1 - group.share()));
    }

    Outcome run(int threads, long leagues, long seed) throws InterruptedException {
        double low = -5;
        double high = 5;
        for (int k = 0; k < HALVINGS; k++) {
            double middle = (low + high) / 2;
            if (elo(group(middle)) < at) {
                low = middle;
            } else {
                high = middle;
            }
        }
        MadeUpGroup group = group((low + high) / 2);
        double[] scores = group.scores();
        double lower = test.lower();
        double upper = test.upper();
        long[] sums = Counted.play(threads, leagues, 2, () -> (number, counts) -> {
            SplitMix64 random = new SplitMix64(seed + number);
            ScoreCounts counted = new ScoreCounts(2);
            double ratio = 0;
            while (ratio > lower && ratio < upper && counted.observations() < LONGEST) {
                counted.add(scores[group.draw(random)]);
                ratio = test.ratio(counted);
            }
            counts[0] += ratio >= upper ? 1 : 0;
            counts[1] += counted.observations();
        });
        return new Outcome((double) sums[0] / leagues, (double) sums[1] / leagues,
            ExpectedLength.of(test, group.share(), Math.sqrt(group.variance()), 2, 0));
    }
}
