package steward.scene;

import steward.physics.Forces;
import steward.physics.Motion;
import steward.physics.OfficialExpressions;

/**
 * Physics that a game defines itself instead of its scenes: official expressions, end of a turn, forces.
 *
 * @param official its referee's expressions for the rung {@code event/official}, or {@code null}
 * @param motion   the end of its turns, or {@code null} where the scene says it
 * @param drag     for people, what {@code motion} does to speeds, such as {@code drag 0.2 to 0.4 by kind}
 * @param forces   on its bodies
 */
public record GameOwn(OfficialExpressions official, Motion motion, String drag, Forces forces) {

    /** A game whose scenes say all. */
    public static final GameOwn NOTHING = new GameOwn(null, null, "");

    /** A game without forces. */
    public GameOwn(OfficialExpressions official, Motion motion, String drag) {
        this(official, motion, drag, Forces.NONE);
    }
}
