package steward.cli.streams;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import steward.text.TextFormat;

/**
 * Progress of a run of many parts, and the time that all the rest will take, on one line of a terminal, or on a line a
 * minute where there is none. Parts differ in length by factors of thousands, so each counts by the time that it is
 * expected to take; how much slower or faster this machine is shows as the run goes on.
 */
public final class RunProgress {

    private static final int STEPS = 1000;
    private static final double NANOS = 1e9;
    /** The expectation weighs as much as this many seconds of the run itself. */
    private static final double TRUST = 10;

    private final Streams streams;
    private final List<Double> expected;
    private final double total;
    private final long startNanos = System.nanoTime();
    private final MinuteLines minutes;
    private ProgressLine line;
    private String part;
    private int begun;
    private volatile double before;
    private volatile double done;

    /** @param expected seconds of each part, in order */
    public RunProgress(Streams streams, List<Double> expected) {
        this.streams = streams;
        minutes = new MinuteLines(streams.err());
        this.expected = List.copyOf(expected);
        total = expected.stream().mapToDouble(Double::doubleValue).sum();
    }

    /** Returns how long all parts together are expected to take, in seconds. */
    public double total() {
        return total;
    }

    /** The next part begins. */
    public void begin(String what) {
        begun++;
        done = before;
        part = begun + " of " + expected.size() + ": " + what;
        line = ProgressLine.watched(streams, part, STEPS, steps(),
            Duration.ofNanos(System.nanoTime() - startNanos), () -> left(elapsed(), done, total));
    }

    /** @param share of the part, 0..1 */
    public void reach(double share) {
        done = before + share * expected.get(begun - 1);
        if (line != null) {
            line.reach(steps());
        } else {
            minutes.say(() -> part + ", " + TextFormat.about(left(elapsed(), done, total)) + " left");
        }
    }

    /** @param steps of how many the part reports each, to {@link #reach} in equal shares; by any thread */
    public Runnable steps(int steps) {
        AtomicInteger taken = new AtomicInteger();
        return () -> reach(Math.min(1, taken.incrementAndGet() / (double) steps));
    }

    /** The part is over, and the line erased. */
    public void end() {
        before += expected.get(begun - 1);
        done = before;
        if (line != null) {
            line.close();
            line = null;
        }
    }

    private int steps() {
        return (int) (STEPS * Math.min(1, done / total));
    }

    private double elapsed() {
        return (System.nanoTime() - startNanos) / NANOS;
    }

    /**
     * Returns how long the rest will take, in seconds.
     *
     * @param elapsed seconds of the run so far
     * @param done    expected seconds of what is done
     * @param total   expected seconds of all
     */
    static double left(double elapsed, double done, double total) {
        return (elapsed + TRUST) / (done + TRUST) * Math.max(0, total - done);
    }
}
