package steward.game;

import java.util.Optional;
import steward.scene.Plan;
import steward.scene.Scene;

/** A game with the settings of one scene, immutable: creates any number of games. */
public interface GameSetup {

    /** The scene it was made from. */
    Scene scene();

    /** The parts that the scene requires, and those left out. */
    Plan plan();

    /** A game before its first turn. All random draws follow from the seed. */
    Game create(long seed);

    /** Reads and writes a game's frames; made by {@link #create} of the same setup. */
    FrameCodec codec(Game game);

    /** The line protocol of a game of the same setup, if this scene has one. */
    default Optional<TextCodec> textCodec(Game game) {
        return Optional.empty();
    }
}
