package steward.lab.cli;

import java.io.IOException;
import java.math.BigDecimal;
import java.math.MathContext;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.Locale;
import steward.cli.shared.FailedException;
import steward.cli.streams.ProgressLine;
import steward.cli.streams.Streams;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.game.GameSetup;
import steward.game.Pilot;
import steward.lab.calibration.Calibration;
import steward.lab.calibration.SeededPlay;
import steward.lab.timing.Machine;
import steward.lab.timing.RungJob;
import steward.lab.timing.Timing;
import steward.lab.timing.TimingEffort;
import steward.scene.AccuracyFigures;
import steward.text.TextFormat;

/**
 * Calibration run of one scene: it measures, writes the figures and prints them. Figures are written to a file beside
 * the final one and moved at the end, so that old figures stay until there are new ones. After an interruption,
 * measured figures are kept.
 */
final class CalibrationRun {

    /** From so many states on a calibration is meant to last, and its costs are timed with all care. */
    private static final int FIRST_LOOK = 10_000;
    private static final int RUNG = 19;
    private static final int COLUMN = 11;
    private static final double LEAST_PLAIN = 1e-3;

    private final Streams streams;
    private final GameSetup setup;
    private final Path file;
    private final Path unfinished;
    private final Calibration calibration;
    private final Timing<RungJob> timing;
    private final String date = LocalDate.now(ZoneOffset.UTC).toString();
    private boolean written;

    /**
     * @param file   for the figures
     * @param timing times the rungs
     */
    CalibrationRun(Streams streams, GameSetup setup, Path file, Calibration calibration,
                   Timing<RungJob> timing) {
        this.timing = timing;
        this.streams = streams;
        this.setup = setup;
        this.file = file;
        this.calibration = calibration;
        unfinished = file.resolveSibling(file.getFileName() + ".part");
    }

    /** @param states how many states; fewer than {@link #FIRST_LOOK} are timed in one JVM a rung only */
    static CalibrationRun of(Streams streams, GameSetup setup, Path file, int states) {
        return of(streams, setup, file, states, Timing.inJvms(states < FIRST_LOOK ? TimingEffort.QUICK
            : TimingEffort.NORMAL, TimingMain.class));
    }

    static CalibrationRun of(Streams streams, GameSetup setup, Path file, int states, Timing<RungJob> timing) {
        return InputException.of("--calibrate: " + setup.scene().name() + ": ", () -> new CalibrationRun(streams, setup,
            file, new Calibration(setup, seed -> new SeededPlay(setup, setup.pilot(Pilot.Aim.WIN), seed), states),
            timing));
    }

    /** Checks that the figures can be written. */
    void begin() {
        try {
            OutputFiles.open(unfinished, true).close();
            Files.delete(unfinished);
        } catch (IOException problem) {
            throw new InputException(file + ": cannot be written: " + OutputFiles.reason(file, problem));
        }
    }

    void run() throws InterruptedException {
        Thread hook = new Thread(this::interrupted, "interruption");
        Runtime.getRuntime().addShutdownHook(hook);
        int steps = timing.steps(calibration.jobs());
        try (ProgressLine progress = ProgressLine.watched(streams, setup.scene().name() + ", costs", steps)) {
            calibration.time(timing, progress::step);
        }
        int threads = Math.min(Runtime.getRuntime().availableProcessors(), calibration.blocks());
        try (ProgressLine progress = ProgressLine.watched(streams, setup.scene().name(), calibration.blocks())) {
            calibration.run(threads, progress::step);
        }
        Calibration.Figures figures = calibration.figures();
        write(figures, file);
        try {
            Runtime.getRuntime().removeShutdownHook(hook);
        } catch (IllegalStateException shutdown) {
            return;
        }
        show(figures);
    }

    /**
     * Writes the measured figures, once.
     *
     * @param place the final file of the figures
     */
    private synchronized void write(Calibration.Figures figures, Path place) {
        if (written || figures.states() == 0) {
            return;
        }
        try {
            Files.writeString(unfinished, calibration.text(figures, date, Machine.line()));
            if (!place.equals(unfinished)) {
                Files.move(unfinished, place, StandardCopyOption.ATOMIC_MOVE);
            }
        } catch (IOException problem) {
            throw new FailedException(place + ": cannot be written: " + problem.getMessage());
        }
        written = true;
    }

    /** Keeps the measured figures: in their file, or beside it if there are older figures, which may be better. */
    void interrupted() {
        Calibration.Figures figures = calibration.figures();
        boolean older = !written && Files.exists(file);
        Path place = older ? unfinished : file;
        write(figures, place);
        streams.err().println(figures.states() == 0 ? "steward: interrupted before anything was measured"
            : "steward: interrupted; the figures of " + figures.states() + " states are in " + place
                + (older ? ", the older ones still in " + file : ""));
    }

    private void show(Calibration.Figures figures) {
        StringBuilder head = new StringBuilder(TextFormat.left("  off by at most u in", RUNG + COLUMN));
        AccuracyFigures.SHARES.forEach(share -> head.append(TextFormat.right(percent(share), COLUMN)));
        head.append(TextFormat.right("largest", COLUMN));
        streams.out().println(setup.scene().name() + ": one turn from each of " + figures.states() + " states, "
            + figures.withImpacts() + " of them with impacts");
        streams.out().println();
        streams.out().println(head);
        streams.out().println(TextFormat.left("  rung", RUNG) + TextFormat.right("cost", COLUMN));
        for (AccuracyFigures.OfRung rung : figures.rungs()) {
            StringBuilder line = new StringBuilder(TextFormat.left("  " + rung.rung(), RUNG));
            line.append(TextFormat.right(String.format(Locale.ROOT, "%.2f", rung.cost()), COLUMN));
            rung.errors().forEach(error -> line.append(TextFormat.right(error(error), COLUMN)));
            line.append(TextFormat.right(error(rung.largest()), COLUMN));
            streams.out().println(line);
        }
        streams.out().println();
        streams.out().println("cost: of a turn, event/double is 1. The shares are of all such states, with 99% "
            + "confidence;");
        streams.out().println("the largest error is of those that were played.");
        streams.out().println();
        streams.out().println("written to " + file);
        streams.out().println("'steward explain' says which rung a scene gets by them that states, say,");
        streams.out().println("  \"accuracy\": { \"maxPositionError\": 0.01, \"share\": 0.999 }");
    }

    /** With three significant digits. */
    private static String error(double value) {
        return value == 0 ? "0" : value == Double.POSITIVE_INFINITY ? AccuracyFigures.UNKNOWN
            : value < LEAST_PLAIN ? String.format(Locale.ROOT, "%.2e", value)
            : new BigDecimal(value).round(new MathContext(3)).toPlainString();
    }

    private static String percent(String share) {
        return new BigDecimal(share).movePointRight(2).stripTrailingZeros().toPlainString() + "%";
    }
}
