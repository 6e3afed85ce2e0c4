package steward.scene;

import java.util.List;

/**
 * The rung on which a scene is computed, and how it was chosen.
 *
 * @param rung   of the ladder
 * @param stated whether the scene file itself names it
 * @param why    for people, a clause that follows the rung's name
 * @param met    for people, a line for each rung that met the scene's demand, cheapest first; empty without a demand
 */
public record AccuracyChoice(Accuracy rung, boolean stated, String why, List<String> met) {

    /** A choice without a demand. */
    public AccuracyChoice(Accuracy rung, boolean stated, String why) {
        this(rung, stated, why, List.of());
    }

    static AccuracyChoice stated(Accuracy rung) {
        return new AccuracyChoice(rung, true, "as the scene says");
    }
}
