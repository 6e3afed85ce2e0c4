package steward.cli.shared;

import java.io.PrintStream;
import me.tongfei.progressbar.ConsoleProgressBarConsumer;
import me.tongfei.progressbar.ProgressBar;
import me.tongfei.progressbar.ProgressBarBuilder;
import me.tongfei.progressbar.ProgressBarStyle;

/** How many games or other steps are done and how long the rest will take, on one line of a terminal; then gone. */
public final class ProgressLine implements AutoCloseable {

    /** Given, because finding out the terminal's width would load a library of its own. */
    private static final int WIDTH = 79;
    private static final int REFRESH_MS = 250;

    private final ProgressBar bar;

    public ProgressLine(PrintStream terminal, int games) {
        this(terminal, "games", games);
    }

    /** @param task what the steps are of */
    public ProgressLine(PrintStream terminal, String task, int steps) {
        bar = new ProgressBarBuilder().setTaskName(task).setInitialMax(steps).setStyle(ProgressBarStyle.ASCII)
            .setUpdateIntervalMillis(REFRESH_MS).clearDisplayOnFinish()
            .setConsumer(new ConsoleProgressBarConsumer(terminal, WIDTH)).build();
    }

    /** One for whoever watches the terminal; {@code null} where nobody does. */
    public static ProgressLine watched(Streams streams, String task, int steps) {
        return streams.errTerminal() ? new ProgressLine(streams.err(), task, steps) : null;
    }

    /** One more; by any thread. */
    public void step() {
        bar.step();
    }

    /** One more, where anybody watches. */
    public static void step(ProgressLine watched) {
        if (watched != null) {
            watched.step();
        }
    }

    @Override
    public void close() {
        bar.close();
    }
}
