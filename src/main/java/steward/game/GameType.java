package steward.game;

import steward.scene.Scene;

/** A kind of game, stateless; the command line lists them all. */
public interface GameType {

    /** The word that scenes name the game by, such as {@code pod-race}. */
    String id();

    /**
     * Reads and checks the game's own blocks of a scene and says which parts it needs.
     *
     * @throws steward.scene.json.SceneException if a block is missing or wrong, or the scene has a field nobody reads
     */
    GameSetup open(Scene scene);
}
