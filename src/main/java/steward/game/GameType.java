package steward.game;

import steward.scene.Scene;

/** A kind of game, stateless; the command line lists them all. */
public interface GameType {

    /** The id of the game in scenes, such as {@code pod-race}. */
    String id();

    /**
     * Reads and checks the game's own blocks of a scene and says which parts it needs.
     *
     * @throws steward.scene.json.SceneException if a block is missing or wrong, or the scene has an unknown field
     */
    GameSetup open(Scene scene);
}
