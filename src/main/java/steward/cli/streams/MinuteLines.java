package steward.cli.streams;

import java.io.PrintStream;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import steward.text.TextFormat;

/** Progress of a long run without a terminal: at most one line a minute, when something is done. */
final class MinuteLines {

    private static final long MINUTE = TimeUnit.MINUTES.toNanos(1);
    private static final double NANOS = 1e9;

    private final PrintStream err;
    private final LongSupplier clock;
    private final long begin;
    private long last;

    MinuteLines(PrintStream err) {
        this(err, System::nanoTime);
    }

    /** @param clock in nanoseconds */
    MinuteLines(PrintStream err, LongSupplier clock) {
        this.err = err;
        this.clock = clock;
        begin = clock.getAsLong();
        last = begin;
    }

    /**
     * Prints how far a task is, and how long the rest takes if it goes on so; nothing within a minute of a line.
     *
     * @param standing is asked where a line is printed; {@code ""} for nothing
     */
    synchronized void say(String task, int done, int steps, Supplier<String> standing) {
        long now = clock.getAsLong();
        if (now - last >= MINUTE) {
            last = now;
            String more = standing.get();
            err.println(TextFormat.plain(task + ": " + done + " of " + steps + (done == 0 ? "" : ", "
                + TextFormat.about((now - begin) / NANOS * Math.max(0, steps - done) / done) + " left")
                + (more.isEmpty() ? "" : ", " + more)));
            err.flush();
        }
    }
}
