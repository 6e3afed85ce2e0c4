package steward.league.sequential;

import steward.league.sequential.Gsprt.Model;

/**
 * What a test is to be expected to cost. The logarithm of the ratio goes nearly as a Brownian motion between two
 * barriers, which overshoots them by 0.583 times the deviation of a step on average (D. Siegmund, "Sequential
 * Analysis", 1985, chapter 10: the barriers are moved out by so much).
 *
 * @param chance       that H1 is accepted
 * @param observations until it ends, expected
 */
public record ExpectedLength(double chance, double observations) {

    private static final double OVERSHOOT = 0.5826;
    private static final double SMALL = 1e-9;

    /**
     * @param test      the test
     * @param mean      the true mean score
     * @param deviation the true standard deviation of an observation
     * @param games     of an observation
     * @param from      where the logarithm of the ratio stands; 0 at the beginning
     */
    public static ExpectedLength of(Gsprt test, double mean, double deviation, int games, double from) {
        double t = (mean - 0.5) / deviation;
        double one = t - test.bound(test.elo0(), games, deviation);
        double other = t - test.bound(test.elo1(), games, deviation);
        double drift = StrictMath.log((1 + one * one) / (1 + other * other)) / 2;
        double step = Math.abs(one / (1 + one * one) - other / (1 + other * other));
        if (test.model() == Model.LOGISTIC) {
            // The bounds move with the deviation, so that what matters is the mean alone.
            step = Math.abs(one - other);
        }
        double below = from - test.lower() + OVERSHOOT * step;
        double above = test.upper() - from + OVERSHOOT * step;
        double twice = 2 * drift / (step * step);
        if (Math.abs(twice) * (above + below) < SMALL) {
            return new ExpectedLength(below / (above + below), above * below / (step * step));
        }
        double chance = -StrictMath.expm1(-twice * below) / -StrictMath.expm1(-twice * (above + below));
        if (twice < 0 && Double.isNaN(chance)) {
            chance = 0;
        }
        return new ExpectedLength(chance, (chance * above - (1 - chance) * below) / drift);
    }
}
