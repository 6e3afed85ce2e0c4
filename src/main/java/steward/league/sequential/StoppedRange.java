package steward.league.sequential;

import java.util.function.DoubleUnaryOperator;
import steward.league.rating.Normal;

/**
 * Range of the true difference after a test, corrected for its stopping: the outcomes are ordered by stages, from a
 * quick H0 over slow ones to a quick H1, and the range has all differences at which neither this outcome or a better
 * one comes with less than alpha nor this or a worse one with less than beta (D. Siegmund, "Estimation following
 * sequential tests", Biometrika 65, 1978; fishtest does so). Its level is 1 - alpha - beta. At elo0 H1 is accepted with
 * the probability alpha, so that the range is above elo0 exactly if it was; likewise it is below elo1 exactly if H0
 * was. While the test is open, the range has those of all ends that it can still have.
 *
 * <p>The logarithm of the ratio is taken for a Brownian motion without overshoot: with d the distance of elo1 and elo0
 * in standard deviations of an observation, n observations are the time n d^2, in which it drifts by the true
 * difference's distance from the middle of both, as a share of d. Normalized Elo has the deviation in its denominator:
 * far from 0 its range is widened by that. A ratio that is farther beyond its bound than one observation or a small
 * batch takes it did not stop the test: then the number of observations was fixed, and the range is the normal one.
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

    private static final int HALVINGS = 60;
    /** Drift at elo1, and less than 0 at elo0. */
    private static final double HALF = 0.5;
    /** Share of a bound by which games that come in batches pass it; fishtest's tests do. */
    private static final double BATCH = 0.03;
    /** Normal deviations of a drift that is surely too far. */
    private static final double FARTHEST = 40;

    /** Expects observations. */
    static StoppedRange of(Gsprt test, ScoreCounts scores) {
        boolean isNormalized = test.model() == Gsprt.Model.NORMALIZED;
        double unit = isNormalized ? Math.sqrt(scores.games()) / Gsprt.NORMALIZED : 1;
        double low = isNormalized ? test.elo0() * unit : Gsprt.score(test.elo0());
        double high = isNormalized ? test.elo1() * unit : Gsprt.score(test.elo1());
        double even = isNormalized ? 0 : 0.5;
        double apart = (high - low) / (isNormalized ? 1 : Math.sqrt(scores.variance()));
        double ratio = test.ratio(scores);
        double time = scores.observations() * apart * apart;
        Gsprt.State state = test.state(scores);
        double seen = ((isNormalized ? (scores.mean() - 0.5) / Math.sqrt(scores.variance()) : scores.mean())
            - (low + high) / 2) / (high - low);
        double barrier = state == Gsprt.State.H1 ? test.upper() : test.lower();
        boolean isStopped = Math.abs(ratio - barrier) <= Math.max(BATCH * Math.abs(barrier), test.greatestStep(scores));
        double reached = state == Gsprt.State.OPEN || !isStopped ? time
            : seen * barrier > 0 ? barrier / seen : time * barrier / ratio;
        DoubleUnaryOperator elo = drift -> {
            double value = (low + high) / 2 + drift * (high - low);
            return isNormalized ? value / unit : value <= 0 ? Double.NEGATIVE_INFINITY
                : value >= 1 ? Double.POSITIVE_INFINITY : Gsprt.logistic(value);
        };
        BrownianExit exit = new BrownianExit(test.lower(), test.upper());
        DoubleUnaryOperator lost = drift -> exit.below(drift, reached);
        DoubleUnaryOperator notWon = drift -> 1 - exit.above(drift, reached);
        DoubleUnaryOperator fixed = drift -> Normal.below((seen - drift) * Math.sqrt(reached));
        DoubleUnaryOperator worse = state == Gsprt.State.OPEN ? drift -> exit.worse(drift, reached, ratio)
            : !isStopped ? fixed : state == Gsprt.State.H1 ? notWon : lost;
        double span = FARTHEST / Math.sqrt(reached) + FARTHEST / reached + Math.abs(seen);
        DoubleUnaryOperator least = state == Gsprt.State.OPEN ? lost : worse;
        DoubleUnaryOperator most = state == Gsprt.State.OPEN ? notWon : worse;
        double low0 = root(least, 1 - test.alpha(), span);
        double high0 = root(most, test.beta(), span);
        double wider = !isNormalized || state == Gsprt.State.OPEN ? 1
            : Math.max(1, Math.sqrt(spread(scores) * reached / time));
        double widened = seen + wider * (low0 - seen);
        double lowest = state == Gsprt.State.H1 && widened <= -HALF ? low0 : widened;
        double raised = seen + wider * (high0 - seen);
        double highest = state == Gsprt.State.H0 && raised >= HALF ? high0 : raised;
        DoubleUnaryOperator score = drift -> {
            double value = (low + high) / 2 + drift * (high - low);
            return Math.max(0, Math.min(1, isNormalized ? 0.5 + value * Math.sqrt(scores.variance()) : value));
        };
        return new StoppedRange(elo.applyAsDouble(lowest), elo.applyAsDouble(root(worse, 0.5, span)),
            elo.applyAsDouble(highest), score.applyAsDouble(lowest), score.applyAsDouble(highest),
            worse.applyAsDouble((even - (low + high) / 2) / (high - low)));
    }

    /**
     * Variance of the mean score's distance from 1/2 in standard deviations, t, times the observations, by the delta
     * method: 1 - t g + t^2 (k - 1)/4 with the skewness g and the kurtosis k of the scores.
     */
    private static double spread(ScoreCounts scores) {
        double[] shares = scores.frequencies();
        double[] moments = new double[5];
        double mean = 0;
        for (int cell = 0; cell < shares.length; cell++) {
            mean += shares[cell] * scores.values()[cell];
        }
        for (int cell = 0; cell < shares.length; cell++) {
            double power = shares[cell];
            for (int order = 1; order < moments.length; order++) {
                power *= scores.values()[cell] - mean;
                moments[order] += power;
            }
        }
        double deviation = Math.sqrt(moments[2]);
        double t = (mean - 0.5) / deviation;
        return 1 - t * moments[3] / (moments[2] * deviation) + t * t * (moments[4] / (moments[2] * moments[2]) - 1) / 4;
    }

    /** The drift at which a probability, which falls with it, has a value. */
    private static double root(DoubleUnaryOperator falling, double value, double span) {
        double low = -span;
        double high = span;
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

    /** True if nothing is known on one side. */
    public boolean isOpen() {
        return Double.isInfinite(low) || Double.isInfinite(high);
    }
}
