package steward.cli;

import java.io.PrintStream;
import me.tongfei.progressbar.ConsoleProgressBarConsumer;
import me.tongfei.progressbar.ProgressBar;
import me.tongfei.progressbar.ProgressBarBuilder;
import me.tongfei.progressbar.ProgressBarStyle;

/** How many games are played and how long the rest will take, on one line of a terminal; gone at the end. */
final class ProgressLine implements AutoCloseable {

    /** Given, because finding out the terminal's width would load a library of its own. */
    private static final int WIDTH = 79;
    private static final int REFRESH_MS = 250;

    private final ProgressBar bar;

    ProgressLine(PrintStream terminal, int games) {
        bar = new ProgressBarBuilder().setTaskName("games").setInitialMax(games).setStyle(ProgressBarStyle.ASCII)
            .setUpdateIntervalMillis(REFRESH_MS).clearDisplayOnFinish()
            .setConsumer(new ConsoleProgressBarConsumer(terminal, WIDTH)).build();
    }

    /** One game more; by any thread. */
    void step() {
        bar.step();
    }

    @Override
    public void close() {
        bar.close();
    }
}
