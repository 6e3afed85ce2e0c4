package steward.league.sequential;

/**
 * Expected number of further observations until a sequential test ends. The logarithm of the ratio is nearly a Brownian
 * motion between two barriers, which it overshoots by 0.583 times the deviation of a step on average (D. Siegmund,
 * "Sequential Analysis", 1985, chapter 10: the barriers are moved out by so much). A step is log(p1/p0) of the cell
 * that occurred: its mean is the drift.
 *
 * @param chance       that H1 is accepted
 * @param observations until it ends, expected
 */
public record ExpectedLength(double chance, double observations) {

    private static final double OVERSHOOT = 0.5826;
    private static final double SMALL = 1e-9;
    /** Steps that deviate by less than this share of their mean are all alike: each goes the same way. */
    private static final double ALIKE = 0.05;

    /**
     * @param scores how they came, and will come
     * @param from   where the logarithm of the ratio stands; 0 at the beginning
     */
    public static ExpectedLength of(Gsprt test, ScoreCounts scores, double from) {
        double[] logs = test.logs(scores);
        double[] shares = scores.frequencies();
        double drift = 0;
        double square = 0;
        for (int k = 0; k < logs.length; k++) {
            drift += shares[k] * logs[k];
            square += shares[k] * logs[k] * logs[k];
        }
        double step = Math.sqrt(Math.max(0, square - drift * drift));
        if (step < Math.abs(drift) * ALIKE) {
            double missing = drift > 0 ? test.upper() - from : from - test.lower();
            return new ExpectedLength(drift > 0 ? 1 : 0, Math.max(0, missing / Math.abs(drift)));
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
