package steward.scene;

import java.math.BigDecimal;
import steward.scene.json.Wording;

/**
 * A scene's demand in place of a rung: after one turn, the position error is at most {@code maxPositionError} in the
 * given share of the states of a calibration. A measured figure, not a guarantee.
 *
 * @param maxPositionError in u, for the body of a state with the largest error; before rounding at the end of the turn
 * @param share            of the states, above 0, at most 1
 */
public record AccuracyDemand(double maxPositionError, double share) {

    /** Returns the demand in words, as in {@code at most 0.01 u in 99.9% of states}. */
    public String text() {
        return "at most " + Wording.number(maxPositionError) + " u in " + percent(share) + " of states";
    }

    /** A share in percent, with all its digits and no trailing zeros. */
    static String percent(double share) {
        return BigDecimal.valueOf(share).movePointRight(2).stripTrailingZeros().toPlainString() + "%";
    }
}
