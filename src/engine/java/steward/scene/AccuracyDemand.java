package steward.scene;

import java.math.BigDecimal;
import steward.scene.json.Wording;

/**
 * A scene's demand from which a rung is chosen: a greatest position error after one turn, in a share of states. The
 * error is at most {@code maxPositionError} in the given share of the states of a calibration, and a turn costs at most
 * {@code maxCost}. These are measured figures, not guarantees.
 *
 * @param maxPositionError in u, for the body of a state with the largest error; before rounding at the end of the turn;
 *                         {@code POSITIVE_INFINITY} for any
 * @param share            of the states, above 0, at most 1
 * @param maxCost          in turns of {@code event/double}; {@code POSITIVE_INFINITY} for any
 * @param maxNanos         in nanoseconds, as the calibration timed a turn; {@code POSITIVE_INFINITY} for any
 */
public record AccuracyDemand(double maxPositionError, double share, double maxCost, double maxNanos) {

    /** A demand of an error, whatever it costs. */
    public AccuracyDemand(double maxPositionError, double share) {
        this(maxPositionError, share, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY);
    }

    boolean hasError() {
        return maxPositionError < Double.POSITIVE_INFINITY;
    }

    boolean hasCost() {
        return maxCost < Double.POSITIVE_INFINITY || maxNanos < Double.POSITIVE_INFINITY;
    }

    /** The cost in words, as in {@code at most 1.5 turns of event/double}. */
    String costText() {
        return "at most " + (maxNanos < Double.POSITIVE_INFINITY ? Wording.number(maxNanos / 1000) + " us a turn"
            : Wording.number(maxCost) + " turns of event/double");
    }

    /** Returns the demand in words, as in {@code at most 0.01 u in 99.9% of states}. */
    public String text() {
        String error = "at most " + Wording.number(maxPositionError) + " u in " + percent(share) + " of states";
        return !hasCost() ? error : hasError() ? error + " for " + costText() : costText();
    }

    /** A share in percent, with all its digits and no trailing zeros. */
    static String percent(double share) {
        return BigDecimal.valueOf(share).movePointRight(2).stripTrailingZeros().toPlainString() + "%";
    }
}
