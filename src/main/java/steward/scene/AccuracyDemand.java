package steward.scene;

import java.math.BigDecimal;
import steward.Internal;
import steward.scene.json.Wording;

/**
 * What a scene may ask for in place of a rung: over one turn, bodies are where they belong to {@code maxPositionError}
 * in so many of the states that a calibration has seen. A measured figure, not a guarantee.
 *
 * @param maxPositionError in u, for the body of a state that is off the most; before rounding at the end of the turn
 * @param share            of the states, above 0, at most 1
 */
@Internal
public record AccuracyDemand(double maxPositionError, double share) {

    /** As in {@code at most 0.01 u in 99.9% of states}. */
    public String text() {
        return "at most " + Wording.number(maxPositionError) + " u in " + percent(share) + " of states";
    }

    /** A share in percent, all its digits and no more. */
    static String percent(double share) {
        return BigDecimal.valueOf(share).movePointRight(2).stripTrailingZeros().toPlainString() + "%";
    }
}
