package steward.cli.streams;

import java.io.PrintStream;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Supplier;
import me.tongfei.progressbar.ConsoleProgressBarConsumer;
import me.tongfei.progressbar.ProgressBar;
import me.tongfei.progressbar.ProgressBarBuilder;
import me.tongfei.progressbar.ProgressBarStyle;
import steward.text.TextFormat;

/**
 * Progress of games or other steps, with the remaining time. On a terminal it is one line, erased at the end; otherwise
 * a line a minute.
 */
public final class ProgressLine implements AutoCloseable {

    /** Fixed, because finding the terminal's width would need another library. */
    private static final int WIDTH = 79;
    private static final int REFRESH_MS = 250;
    private static final long REFRESH_NANOS = REFRESH_MS * 1_000_000L;

    /** How long the text about the standing may be, so that there is room for the bar. */
    private static final int WORD = 24;

    /** {@code null} where there is no terminal. */
    private final ProgressBar bar;
    private final MinuteLines minutes;
    private final String task;
    private final int steps;
    private final AtomicInteger done = new AtomicInteger();
    /** When a terminal's line last asked for the standing. */
    private long shown = System.nanoTime() - REFRESH_NANOS;
    private boolean closed;

    /** Without a terminal. */
    ProgressLine(MinuteLines minutes, String task, int steps) {
        bar = null;
        this.minutes = minutes;
        this.task = task;
        this.steps = steps;
    }

    private ProgressLine(PrintStream terminal, String task, int steps) {
        minutes = null;
        this.task = task;
        this.steps = steps;
        bar = new ProgressBarBuilder().setTaskName(task).setInitialMax(steps).setStyle(ProgressBarStyle.ASCII)
            .setUpdateIntervalMillis(REFRESH_MS).clearDisplayOnFinish()
            .setConsumer(new ConsoleProgressBarConsumer(terminal, WIDTH)).build();
    }

    /** A line on the standard error. */
    public static ProgressLine watched(Streams streams, String task, int steps) {
        return streams.errTerminal() ? new ProgressLine(streams.err(), task, steps)
            : new ProgressLine(new MinuteLines(streams.err()), task, steps);
    }

    /** Says on a terminal how long the command will take, and that it may be broken off. */
    public static void announce(Streams streams, String duration) {
        if (streams.errTerminal()) {
            streams.err().println("This takes " + duration + "; Ctrl-C ends it and keeps what is complete.");
        }
    }

    /** Sets how many there are in all; by any thread. */
    public void reach(int reached) {
        if (bar == null) {
            minutes.say(task, reached, steps, () -> "");
        } else {
            bar.stepTo(reached);
        }
    }

    /** One more; by any thread. */
    public void step() {
        if (bar == null) {
            minutes.say(task, done.incrementAndGet(), steps, () -> "");
        } else {
            bar.step();
        }
    }

    /** One more, with a text about the standing; by any thread. */
    public void step(String standing) {
        if (bar != null) {
            bar.setExtraMessage(TextFormat.plain(TextFormat.shorten(standing, WORD)));
        }
        step();
    }

    /**
     * One more, with a text that takes time to find; by one thread.
     *
     * @param standing is asked only where a line is written; {@code ""} for nothing
     */
    public void step(Supplier<String> standing) {
        if (bar == null) {
            minutes.say(task, done.incrementAndGet(), steps, standing);
        } else if (System.nanoTime() - shown >= REFRESH_NANOS) {
            shown = System.nanoTime();
            step(standing.get());
        } else {
            step();
        }
    }

    /** The second time there is nothing to do. */
    @Override
    public synchronized void close() {
        if (!closed) {
            closed = true;
            if (bar != null) {
                bar.close();
            }
        }
    }
}
