package steward.cli.options;

import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import steward.cli.streams.StandardFiles;
import steward.cli.streams.Streams;
import steward.game.GameSetup;

/** Options for the scene that is played and its rung of accuracy. */
public final class SceneOptions {

    /** The scene that is played unless another is called for. */
    public static final String USUAL = "mad-pod-racing";
    public static final String DESCRIPTION
        = "The scene: a file, - for the standard input, or one of ${COMPLETION-CANDIDATES} (default: "
        + "${DEFAULT-VALUE}).";

    @Option(names = "--scene", paramLabel = "FILE|NAME", defaultValue = USUAL,
        completionCandidates = ShippedScenes.class, description = DESCRIPTION)
    private String scene;

    @Mixin
    private final AccuracyOption accuracy = new AccuracyOption();

    /** True if the scene is read from the standard input. */
    public boolean isPiped() {
        return StandardFiles.is(scene);
    }

    /** The scene as it was typed. */
    public String typed() {
        return scene;
    }

    public GameSetup open(Streams streams) {
        return accuracy.open(scene, streams);
    }
}
