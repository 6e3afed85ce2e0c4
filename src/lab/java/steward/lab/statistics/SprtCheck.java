package steward.lab.statistics;

import steward.league.rating.RatingFit;
import steward.league.sequential.ExpectedLength;
import steward.league.sequential.Gsprt;
import steward.league.sequential.ScoreCounts;
import steward.league.sequential.SequentialBar;
import steward.numerics.SplitMix64;

/**
 * Errors and lengths of sequential tests.
 *
 * @param at    what the true difference is, in the test's Elo
 * @param ties  weight of ties
 * @param push  what a seed is worth to one of the two, in Elo
 * @param alike observations at the beginning that are all even, as of bots that have not yet met a seed that matters
 */
record SprtCheck(Gsprt test, double at, double ties, double push, int alike) {

    private static final double HALF = 0.5;
    private static final long LONGEST = 10_000_000;
    private static final int HALVINGS = 60;
    /** In natural units: more than any Elo of a test. */
    private static final double FARTHEST = 10;
    /** Observations that stand for the truth. */
    private static final long MANY = 1L << 40;

    /**
     * Result of a check.
     *
     * @param accepted share of the tests that accepted H1
     * @param mean     observations until they ended
     * @param held     share of the tests at whose end the truth was in the range
     */
    record Outcome(double accepted, double mean, ExpectedLength theory, double held) { }

    /** Observations that surely decide nothing, and one: half of those that would be needed if all went one way. */
    private int steps(ScoreCounts counted) {
        if (counted.observations() < Gsprt.LEAST) {
            return 1;
        }
        double ratio = test.ratio(counted);
        double distance = Math.min(test.upper() - ratio, ratio - test.lower());
        return 1 + (int) (distance / 2 / test.greatestStep(counted));
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
        double low = -FARTHEST;
        double high = FARTHEST;
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
        long[] sums = Counted.play(threads, leagues, 3, () -> (number, counts) -> {
            SplitMix64 random = new SplitMix64(seed + number);
            ScoreCounts counted = new ScoreCounts(2);
            counted.add(HALF, alike);
            Gsprt.State state = Gsprt.State.OPEN;
            while (state == Gsprt.State.OPEN && counted.observations() < LONGEST) {
                for (int step = steps(counted); step > 0; step--) {
                    counted.add(scores[group.draw(random)]);
                }
                state = test.state(counted);
            }
            counts[0] += state == Gsprt.State.H1 ? 1 : 0;
            counts[1] += counted.observations();
            SequentialBar range = test.range(counted);
            counts[2] += range.low() <= at && at <= range.high() ? 1 : 0;
        });
        ScoreCounts truth = new ScoreCounts(2);
        double[] chances = group.chances();
        for (int k = 0; k < chances.length; k++) {
            truth.add(scores[k], Math.round(chances[k] * MANY));
        }
        return new Outcome((double) sums[0] / leagues, (double) sums[1] / leagues, ExpectedLength.of(test, truth, 0),
            (double) sums[2] / leagues);
    }
}
