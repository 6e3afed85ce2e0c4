package steward.cli.shared;

import java.io.PrintStream;
import me.tongfei.progressbar.ConsoleProgressBarConsumer;
import me.tongfei.progressbar.ProgressBar;
import me.tongfei.progressbar.ProgressBarBuilder;
import me.tongfei.progressbar.ProgressBarStyle;

/**
 * How many games or other steps are done and how long the rest will take, on one line of a terminal, erased at the end.
 */
public final class ProgressLine implements AutoCloseable {

    /** Fixed, because finding the terminal's width would need another library. */
    private static final int WIDTH = 79;
    private static final int REFRESH_MS = 250;

    private final ProgressBar bar;

    public ProgressLine(PrintStream terminal, int games) {
        this(terminal, "games", games);
    }

    /** @param task what is being done */
    public ProgressLine(PrintStream terminal, String task, int steps) {
        bar = new ProgressBarBuilder().setTaskName(task).setInitialMax(steps).setStyle(ProgressBarStyle.ASCII)
            .setUpdateIntervalMillis(REFRESH_MS).clearDisplayOnFinish()
            .setConsumer(new ConsoleProgressBarConsumer(terminal, WIDTH)).build();
    }

    /** One more; by any thread. */
    public void step() {
        bar.step();
    }

    @Override
    public void close() {
        bar.close();
    }
}
