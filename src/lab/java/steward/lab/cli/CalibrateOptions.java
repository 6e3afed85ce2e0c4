package steward.lab.cli;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import picocli.CommandLine.Option;
import steward.cli.options.CallCheck;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.Games;
import steward.cli.streams.ProgressLine;
import steward.cli.streams.Streams;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.game.GameSetup;
import steward.lab.calibration.Calibration;
import steward.scene.AccuracyFigures;
import steward.scene.SceneFiles;
import steward.text.TextFormat;

/** Options of {@code steward tradeoff} for calibrating scenes. */
final class CalibrateOptions {

    private static final int MOST_STATES = 10_000_000;
    /** How long a state takes, approximately: 2000 of mad-pod-racing 1 s of CPU, on two processors. */
    private static final double STATE_SECONDS = 3e-4;
    /** How long the costs of a scene take, approximately. */
    private static final double COST_SECONDS = 30;
    /** From so many seconds on a run says beforehand how long it takes. */
    private static final double ANNOUNCED = 5;

    private final CallCheck check = CallCheck.brief();

    @Option(names = "--calibrate", paramLabel = "SCENE", description = "Instead: measures error and cost of each "
        + "rung in this scene, and writes them to NAME.accuracy.json beside the file (or into --out). A scene "
        + "with \"accuracy\": {\"maxPositionError\": 0.01, \"share\": 0.999} reads them there. Can be repeated.")
    private List<String> scenes = new ArrayList<>();

    @Option(names = "--states", paramLabel = "N", description = "With --calibrate: measures on this many states "
        + "(default: 100000). With fewer than 10000 costs are measured roughly, too.")
    private Integer states;

    boolean isAsked() {
        return !scenes.isEmpty() || states != null;
    }

    /**
     * Calibrates all scenes, after checking that all of them can be read and all figures written.
     *
     * @param out a folder for the figures, or {@code null} to put them beside the scenes
     */
    int run(Streams streams, String out, boolean overwrite) throws InterruptedException {
        check.that(!scenes.isEmpty(), "--states: expected --calibrate with it");
        check.range("--states", states, 1, MOST_STATES);
        List<CalibrationRun> all = new ArrayList<>();
        List<Path> files = new ArrayList<>();
        for (String scene : scenes) {
            // On any rung: the scene may demand an accuracy whose rung only this calibration can determine.
            GameSetup setup = Games.warn(Games.open(scene, Calibration.PLAYED_ON), streams);
            Path file = file(scene, out);
            if (files.contains(file.toAbsolutePath().normalize())) {
                throw new InputException("--calibrate: found two scenes for " + file + ", expected one");
            }
            files.add(file.toAbsolutePath().normalize());
            OutputFiles.check(file, overwrite);
            all.add(CalibrationRun.of(streams, setup, file, states == null ? Calibration.STATES : states));
        }
        if (out != null) {
            OutputFiles.prepareFolder(OutputFiles.path(out));
        }
        for (CalibrationRun each : all) {
            each.begin();
        }
        double seconds = all.size() * (COST_SECONDS + (states == null ? Calibration.STATES : states) * STATE_SECONDS);
        if (seconds >= ANNOUNCED) {
            ProgressLine.announce(streams, TextFormat.about(seconds));
        }
        for (CalibrationRun each : all) {
            each.run();
        }
        return ExitStatus.DONE;
    }

    private static Path file(String scene, String out) {
        Path path = OutputFiles.path(scene);
        boolean isFile = Files.isRegularFile(path);
        if (!isFile && out == null) {
            throw new InputException("--calibrate: the scene " + scene + " comes with the program, its figures too; "
                + "expected a scene file, or --out with a folder for the figures");
        }
        Path beside = SceneFiles.load(scene).figures().orElse(AccuracyFigures.beside(path));
        return out == null ? beside : OutputFiles.path(out).resolve(beside.getFileName());
    }
}
