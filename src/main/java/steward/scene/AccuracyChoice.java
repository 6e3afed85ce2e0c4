package steward.scene;

import steward.Internal;

/**
 * The rung that a scene is computed on, and how it came to be that one.
 *
 * @param rung   of the ladder
 * @param stated whether the scene file itself names it
 * @param why    for people, a clause to follow the rung's name
 */
@Internal
public record AccuracyChoice(Accuracy rung, boolean stated, String why) {

    /** Named by the scene file. */
    static AccuracyChoice stated(Accuracy rung) {
        return new AccuracyChoice(rung, true, "as the scene says");
    }
}
