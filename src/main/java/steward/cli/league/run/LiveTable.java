package steward.cli.league.run;

import java.io.PrintStream;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import steward.contest.WorkerThreads;

/** Terminal output of a run: messages, and below them a block of lines that is rewritten in place. */
final class LiveTable implements AutoCloseable {

    private static final long PERIOD_MS = 500;
    private static final String UP = "\u001b[%dA";
    private static final String CLEAR = "\u001b[J";

    private final PrintStream terminal;
    private Supplier<List<String>> content;
    private final ScheduledExecutorService clock = Executors.newSingleThreadScheduledExecutor(
        WorkerThreads.daemons("live table"));
    private int lines;
    private boolean closed;

    LiveTable(PrintStream terminal) {
        this.terminal = terminal;
    }

    /** Draws lines from now on. */
    synchronized void draw(Supplier<List<String>> lines) {
        content = lines;
        clock.scheduleWithFixedDelay(this::draw, PERIOD_MS, PERIOD_MS, TimeUnit.MILLISECONDS);
    }

    private void draw() {
        List<String> now = new ArrayList<>(content.get());
        synchronized (this) {
            if (!closed) {
                erase();
                now.forEach(terminal::println);
                terminal.flush();
                lines = now.size();
            }
        }
    }

    private void erase() {
        if (lines > 0) {
            terminal.print(String.format(UP, lines) + "\r" + CLEAR);
        }
        lines = 0;
    }

    /** Prints a line that stays. */
    synchronized void say(String line) {
        erase();
        terminal.println(line);
    }

    /** Erases the lines. */
    @Override
    public synchronized void close() {
        if (!closed) {
            closed = true;
            clock.shutdownNow();
            erase();
            terminal.flush();
        }
    }
}
