package steward.cli.shared;

import java.util.List;
import steward.game.GameSetup;
import steward.game.GameTypes;
import steward.game.meanmax.protocol.MeanMaxType;
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
        return new GameTypes(List.of(new PodRaceType(), new MeanMaxType()));
    }

    /** Opens a scene by its path or shipped name. A scene whose games cannot begin is refused. */
    public static GameSetup open(String scene) {
        return open(scene, null);
    }

    /** @param accuracy the rung to use, or {@code null} for the scene's own */
    public static GameSetup open(String scene, Accuracy accuracy) {
        GameSetup setup = types().open(SceneReader.read(SceneFiles.load(scene), accuracy));
        setup.check();
        return setup;
    }

    /** Prints what is odd about a scene; once per call of the program. */
    public static GameSetup warn(GameSetup setup, Streams streams) {
        setup.check().forEach(streams::warn);
        return setup;
    }
}
