package steward.league.sequential;

import java.util.Arrays;
import java.util.function.DoubleBinaryOperator;
import java.util.function.DoubleUnaryOperator;
import steward.league.rating.Normal;

/**
 * Confidence range of the true difference after a sequential test, corrected for its stopping. Outcomes are ordered by
 * stages, from a quick H0 over slow ones to a quick H1. The range contains a difference unless an outcome as good as
 * this or better has there a probability below alpha, or one as bad or worse a probability below beta (D. Siegmund,
 * "Estimation following sequential tests", Biometrika 65, 1978; fishtest does so). Its level is 1 - alpha - beta. At
 * elo0 H1 is accepted with the probability alpha, so that the range is above elo0 exactly if H1 was accepted; likewise
 * it is below elo1 exactly if H0 was. While the test is open, the range is that of a test that ends here, and contains
 * elo0 and elo1.
 *
 * <p>At each difference the logarithm of the ratio is treated as a Brownian motion without overshoot (see {@link
 * Motion}). A ratio farther beyond its bound than one observation or a small batch takes it did not stop the test: then
 * the number of observations was fixed, and the range is the normal one.
 *
 * @param low         in the test's Elo; -infinity where any is possible
 * @param elo         the estimate that is as probably too low as too high
 * @param high        infinity where any is possible
 * @param scoreLow    the lowest mean score, 0..1
 * @param scoreHigh   the highest
 * @param superiority likelihood of superiority: probability of a worse outcome if both were equal
 */
public record StoppedRange(double low, double elo, double high, double scoreLow, double scoreHigh,
                           double superiority) {

    private static final int HALVINGS = 32;
    /** Share of a bound by which games that come in batches pass it; fishtest's tests do. */
    private static final double BATCH = 0.03;
    /** In Elo; a range that goes beyond has no end: a bot wins 999,999 of a million. */
    private static final double FARTHEST = 2400;

    /** Chance of a cell; from a smaller one the way back to the hypotheses is lost in rounding. */
    private static final double RAREST = 1e-9;

    /**
     * Brownian motion of the logarithm of the ratio at a true difference. If scores came as is most likely with it,
     * each observation would change the logarithm by the mean and the variance of log(p1/p0) over the cells, p0 and p1
     * those of such scores: the logarithm is n times a function of the frequencies, and log(p1/p0) is its derivative.
     * Far from the hypotheses both are much less than at them. Drifts are scaled so that those at elo0 and elo1 are
     * -1/2 and 1/2 of the variance; they are nearly.
     */
    private static final class Motion {

        private final Gsprt test;
        private final ScoreCounts scores;
        private final double zero;
        private final double one;

        /** @param isScaled whether drifts are scaled */
        Motion(Gsprt test, ScoreCounts scores, boolean isScaled) {
            this.test = test;
            this.scores = scores;
            zero = isScaled ? drift(moments(test.elo0())) : -0.5;
            one = isScaled ? drift(moments(test.elo1())) : 0.5;
        }

        private static double drift(double... moments) {
            return moments[0] / moments[1];
        }

        /** Mean and variance of a change, with two observations of even games as of {@link ScoreCounts#variance}. */
        private double[] moments(double elo) {
            double[] chances = Arrays.stream(test.likely(scores, elo, scores.frequencies()))
                .map(chance -> Math.max(RAREST, chance)).toArray();
            double[] logs = test.logs(scores, chances);
            double mean = 0;
            double square = 0;
            for (int cell = 0; cell < logs.length; cell++) {
                mean += chances[cell] * logs[cell];
                square += chances[cell] * logs[cell] * logs[cell];
            }
            double span = Arrays.stream(logs).max().orElseThrow() - Arrays.stream(logs).min().orElseThrow();
            return new double[] {mean, scores.mixed(square - mean * mean, span)};
        }

        /** Returns the probability of a worse outcome by the difference, after so many observations. */
        DoubleUnaryOperator worse(double observations, DoubleBinaryOperator worse) {
            return elo -> {
                double[] moments = moments(elo);
                return worse.applyAsDouble((drift(moments) - (zero + one) / 2) / (one - zero),
                    observations * moments[1]);
            };
        }

        /** Returns the mean score. */
        double score(double elo) {
            double[] chances = test.likely(scores, elo, scores.frequencies());
            double mean = 0;
            for (int cell = 0; cell < chances.length; cell++) {
                mean += chances[cell] * scores.values()[cell];
            }
            return mean;
        }
    }

    /** Expects observations. */
    static StoppedRange of(Gsprt test, ScoreCounts scores) {
        BrownianExit exit = new BrownianExit(test.lower(), test.upper());
        double ratio = test.ratio(scores);
        Gsprt.State state = test.state(scores);
        double barrier = state == Gsprt.State.H1 ? test.upper() : test.lower();
        boolean isStopped = Math.abs(ratio - barrier) <= Math.max(BATCH * Math.abs(barrier), test.greatestStep(scores));
        Motion motion = new Motion(test, scores, state == Gsprt.State.OPEN || isStopped);
        double reached = scores.observations() * (state == Gsprt.State.OPEN || !isStopped ? 1 : barrier / ratio);
        DoubleBinaryOperator notWon = (drift, time) -> 1 - exit.above(drift, time);
        DoubleBinaryOperator fixed = (drift, time) -> Normal.below((ratio - drift * time) / Math.sqrt(time));
        DoubleBinaryOperator worse = state == Gsprt.State.OPEN ? (drift, time) -> exit.worse(drift, time, ratio)
            : !isStopped ? fixed : state == Gsprt.State.H1 ? notWon : exit::below;
        DoubleUnaryOperator found = motion.worse(reached, worse);
        double low = Math.min(root(found, 1 - test.alpha()),
            state == Gsprt.State.OPEN ? test.elo0() : Double.POSITIVE_INFINITY);
        double high = Math.max(root(found, test.beta()),
            state == Gsprt.State.OPEN ? test.elo1() : Double.NEGATIVE_INFINITY);
        return new StoppedRange(low, root(found, 0.5), high, Double.isInfinite(low) ? 0 : motion.score(low),
            Double.isInfinite(high) ? 1 : motion.score(high), found.applyAsDouble(0));
    }

    /** The difference at which a probability, which falls with it, has a value; infinite if it has it nowhere. */
    private static double root(DoubleUnaryOperator falling, double value) {
        double low = -FARTHEST;
        double high = FARTHEST;
        if (falling.applyAsDouble(low) <= value) {
            return Double.NEGATIVE_INFINITY;
        }
        if (falling.applyAsDouble(high) >= value) {
            return Double.POSITIVE_INFINITY;
        }
        for (int k = 0; k < HALVINGS; k++) {
            double middle = (low + high) / 2;
            if (falling.applyAsDouble(middle) > value) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return (low + high) / 2;
    }
}
