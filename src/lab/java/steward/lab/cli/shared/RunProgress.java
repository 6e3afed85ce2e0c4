package steward.lab.cli.shared;

import java.util.concurrent.atomic.AtomicInteger;
import steward.cli.streams.ProgressLine;
import steward.cli.streams.Streams;

/** Progress of a run of many parts: a {@link ProgressLine} for each, with its number. */
public final class RunProgress {

    private static final int STEPS = 1000;

    private final Streams streams;
    private final int parts;
    private ProgressLine line;
    private int begun;

    public RunProgress(Streams streams, int parts) {
        this.streams = streams;
        this.parts = parts;
    }

    /** The next part begins. */
    public void begin(String what) {
        begun++;
        line = ProgressLine.watched(streams, begun + " of " + parts + ": " + what, STEPS);
    }

    /** @param steps of how many equal shares of the part each is reported; by any thread */
    public Runnable steps(int steps) {
        AtomicInteger taken = new AtomicInteger();
        return () -> line.reach((int) Math.min(STEPS, (long) STEPS * taken.incrementAndGet() / steps));
    }

    /** The part is over, and the line erased. */
    public void end() {
        line.close();
    }
}
