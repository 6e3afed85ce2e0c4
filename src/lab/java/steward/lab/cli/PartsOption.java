package steward.lab.cli;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.List;
import java.util.stream.Collectors;
import picocli.CommandLine.Option;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.FailedException;
import steward.cli.shared.Games;
import steward.cli.streams.Interruption;
import steward.cli.streams.RunProgress;
import steward.cli.streams.Streams;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.game.GameSetup;
import steward.lab.calibration.PartPrices;
import steward.lab.timing.Machine;
import steward.lab.timing.Timing;
import steward.lab.timing.TimingEffort;
import steward.scene.SceneFiles;
import steward.scene.price.StoredPartPrices;

/** The option of {@code steward tradeoff} by which it measures the prices of parts that {@code explain} prints. */
final class PartsOption {

    /** How long a scene takes, approximately, on two processors. */
    private static final double SECONDS = 50;

    @Option(names = "--parts", paramLabel = "FILE", description = "Instead: measures what each part of the engine adds "
        + "to a turn of each shipped scene, and writes it to this file; the program's own, which explain prints, was "
        + "made so.")
    private String file;

    /** True if it was called for. */
    boolean isAsked() {
        return file != null;
    }

    int run(Streams streams, boolean overwrite) {
        return run(streams, overwrite, withPlayers(), Timing.inJvms(TimingEffort.NORMAL, TimingMain.class));
    }

    /**
     * Writes scene by scene to a file beside the final one, which that becomes in the end.
     *
     * @param scenes names of shipped scenes
     */
    int run(Streams streams, boolean overwrite, List<String> scenes, Timing timing) {
        Path target = OutputFiles.path(file);
        OutputFiles.check(target, overwrite);
        Path unfinished = target.resolveSibling(target.getFileName() + ".part");
        begin(unfinished, target);
        String date = LocalDate.now(ZoneOffset.UTC).toString();
        RunProgress progress = new RunProgress(streams, scenes.stream().map(scene -> SECONDS).toList());
        try (Interruption interruption = new Interruption(streams, "the scenes so far are in " + unfinished)) {
            for (String scene : scenes) {
                GameSetup setup = Games.open(scene);
                PartPrices prices = new PartPrices(setup.scene(), Games.types());
                progress.begin(scene);
                List<StoredPartPrices.Row> rows;
                try {
                    rows = PartPrices.rows(setup.scene(), prices.measure(timing,
                        progress.steps(timing.steps(prices.jobs()))), date, Machine.line());
                } finally {
                    progress.end();
                }
                Files.writeString(unfinished, rows.stream().map(row -> row.line() + "\n").collect(Collectors.joining()),
                    StandardCharsets.UTF_8, StandardOpenOption.APPEND);
                streams.out().println(scene + ": " + rows.size() + " parts");
                streams.out().flush();
            }
            Files.move(unfinished, target, StandardCopyOption.REPLACE_EXISTING);
            interruption.over();
        } catch (IOException problem) {
            throw new FailedException(unfinished + ": cannot be written: " + OutputFiles.reason(unfinished, problem));
        }
        streams.out().println("written to " + target);
        streams.out().flush();
        return ExitStatus.DONE;
    }

    private static void begin(Path unfinished, Path target) {
        try {
            Files.writeString(unfinished, String.join(StoredPartPrices.SEPARATOR, StoredPartPrices.COLUMNS) + "\n");
        } catch (IOException problem) {
            throw new InputException(target + ": cannot be written: " + OutputFiles.reason(target, problem));
        }
    }

    /** Shipped scenes without players are left out: what their parts cost depends on where the bodies lie. */
    private static List<String> withPlayers() {
        return SceneFiles.shipped().stream().filter(name -> Games.open(name).scene().players() > 0).toList();
    }
}
