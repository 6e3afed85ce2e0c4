package steward.game.meanmax;

import steward.scene.Scene;
import steward.scene.json.Block;

/**
 * The block {@code harvest} of a scene.
 *
 * @param winningScore the score that ends the game, 1..1000
 * @param maximumTurns turns after which the game ends, 1..10000
 */
public record MeanMaxSettings(int winningScore, int maximumTurns) {

    /** The number of players. */
    public static final int PLAYERS = 3;

    private static final int MOST_WATER = 1000;
    private static final int MOST_TURNS = 10_000;

    /**
     * Reads the block and checks what the game needs of the common ones.
     *
     * @throws steward.scene.json.SceneException if something is missing or not as the game needs it
     */
    public static MeanMaxSettings read(Scene scene) {
        Block root = scene.root();
        if (root.contains("motion")) {
            throw root.error("motion", "a block motion", "none: the end of a turn is part of the rules of Mean Max");
        }
        Block harvest = root.block("harvest");
        return new MeanMaxSettings(harvest.integer("winningScore", 1, MOST_WATER),
            harvest.integer("maximumTurns", 1, MOST_TURNS));
    }
}
