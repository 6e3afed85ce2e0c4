package steward.cli.shared;

import java.util.List;
import steward.game.GameSetup;
import steward.game.GameTypes;
import steward.game.podrace.protocol.PodRaceType;
import steward.scene.Accuracy;
import steward.scene.SceneFiles;
import steward.scene.SceneReader;

/** The games that the program knows, and their scenes. */
public final class Games {

    private Games() {
    }

    /** All games. */
    public static GameTypes types() {
        return new GameTypes(List.of(new PodRaceType()));
    }

    /** Opens a scene by its path or shipped name. */
    public static GameSetup open(String scene) {
        return open(scene, null);
    }

    /** @param accuracy the rung to use, or {@code null} for the scene's own */
    public static GameSetup open(String scene, Accuracy accuracy) {
        return types().open(SceneReader.read(SceneFiles.load(scene), accuracy));
    }
}
