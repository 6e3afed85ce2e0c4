package steward.scene;


/**
 * The rung that a scene is computed on, and how it was chosen.
 *
 * @param rung   of the ladder
 * @param stated whether the scene file itself names it
 * @param why    for people, a clause that follows the rung's name
 */
public record AccuracyChoice(Accuracy rung, boolean stated, String why) {

    /** The rung stated by the scene file. */
    static AccuracyChoice stated(Accuracy rung) {
        return new AccuracyChoice(rung, true, "as the scene says");
    }
}
