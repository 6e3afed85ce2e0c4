package steward.lab.timing;

import java.util.Arrays;
import steward.numerics.Median;

/** The measured rounds of some kinds of turns, and what is said of them: medians, and ratios of the same medians. */
public final class TimingSamples {

    private final double[][][] nanos;
    private final double[] bytes;

    /** @param jobs how many kinds */
    TimingSamples(int jobs, int repeats, int rounds) {
        nanos = new double[jobs][repeats][rounds];
        bytes = new double[jobs];
        Arrays.fill(bytes, Double.POSITIVE_INFINITY);
    }

    void add(int job, int repeat, int round, Stretch stretch) {
        nanos[job][repeat][round] = stretch.nanos();
        bytes[job] = Double.isNaN(stretch.bytes()) ? Double.NaN : Math.min(bytes[job], stretch.bytes());
    }

    /** Returns how many rounds each kind has, of all repeats together. */
    public int rounds() {
        return nanos.length == 0 ? 0 : nanos[0].length * nanos[0][0].length;
    }

    /** Returns the number of repeats, each in places of its own. */
    public int repeats() {
        return nanos.length == 0 ? 0 : nanos[0].length;
    }

    private double[] all(int job) {
        return Arrays.stream(nanos[job]).flatMapToDouble(Arrays::stream).sorted().toArray();
    }

    /** Nanoseconds of a turn: the median of all rounds. */
    public double median(int job) {
        return Median.of(all(job));
    }

    /** The time of a turn as a multiple of another kind's: of the medians. */
    public double ratio(int job, int other) {
        return median(job) / median(other);
    }

    /** Nanoseconds of a turn in each repeat: the median of its rounds. */
    public double[] medians(int job) {
        return Arrays.stream(nanos[job]).mapToDouble(Median::of).toArray();
    }

    /**
     * Bytes that a turn allocates, in the round with the fewest: the JVM's own work (a growing buffer) is no cost of a
     * turn. NaN where the JVM does not tell.
     */
    public double bytes(int job) {
        return bytes[job];
    }
}
