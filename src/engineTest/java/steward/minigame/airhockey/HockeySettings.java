package steward.minigame.airhockey;

import steward.physics.Bodies;
import steward.scene.Field;
import steward.scene.Scene;
import steward.scene.json.Block;

/**
 * The block {@code hockey} of a scene, and its field.
 *
 * @param push the most that a paddle changes its speed by in a turn, in u per turn
 */
record HockeySettings(Field field, double goal, double push, int goalsToWin, int maximumTurns) {

    private static final double[] SHARE_OF_WIDTH = {0.25, 0.75, 0.5};

    static HockeySettings read(Scene scene) {
        Field field = scene.field().filter(of -> of.walls().size() == 5).orElseThrow(() -> scene.root().error(
            "field", "other walls", "five: left, top, right, bottom, centre line"));
        Block hockey = scene.root().block("hockey");
        return new HockeySettings(field, hockey.positive("goal"), hockey.positive("push"),
            hockey.integer("goalsToWin", 1, 100), hockey.integer("maximumTurns", 1, 10_000));
    }

    boolean isInGoal(double y) {
        return Math.abs(y - field.height() / 2) <= goal / 2;
    }

    /** Puts a body at rest where it stands at a kick-off: a paddle in the middle of its half, the puck on the line. */
    void place(Bodies bodies, int body) {
        bodies.setPosition(body, SHARE_OF_WIDTH[body] * field.width(), field.height() / 2);
        bodies.setVelocity(body, 0, 0);
    }
}
