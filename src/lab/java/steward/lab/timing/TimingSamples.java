package steward.lab.timing;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import steward.numerics.Median;

/** Measured rounds of several kinds of work, and their statistics: medians, and ratios of these medians. */
public final class TimingSamples {

    /** By repeat and round; a round has a stretch of each kind. */
    private final List<List<Stretch[]>> repeats = new ArrayList<>();

    /** Begins a repeat, in places of its own. */
    void begin() {
        repeats.add(new ArrayList<>());
    }

    void add(Stretch... round) {
        repeats.get(repeats.size() - 1).add(round);
    }

    /** Returns how many whole rounds there are, of all repeats together. */
    public int rounds() {
        return repeats.stream().mapToInt(List::size).sum();
    }

    /** Returns the number of repeats, each in places of its own. */
    public int repeats() {
        return repeats.size();
    }

    private Stream<Stretch[]> all() {
        return repeats.stream().flatMap(List::stream);
    }

    /** Nanoseconds of a unit: the median of all rounds. */
    public double median(int job) {
        return Median.of(all().mapToDouble(round -> round[job].nanos()).toArray());
    }

    /** The time of a unit as a multiple of another kind's: of the medians. */
    public double ratio(int job, int other) {
        return median(job) / median(other);
    }

    /** Returns the ratio of two kinds of work in each round, ascending. */
    public double[] ratios(int job, int other) {
        return all().mapToDouble(round -> round[job].nanos() / round[other].nanos()).sorted().toArray();
    }

    /** Nanoseconds of a unit in each repeat: the median of its rounds. */
    public double[] medians(int job) {
        return repeats.stream().mapToDouble(rounds -> Median.of(rounds.stream()
            .mapToDouble(round -> round[job].nanos()).toArray())).toArray();
    }

    /**
     * Bytes that a unit allocates, in the round with the fewest: the JVM's own work (a growing buffer) is no cost of a
     * unit. NaN where nobody tells.
     */
    public double bytes(int job) {
        return all().flatMapToDouble(round -> DoubleStream.of(round[job].bytes())).min().orElse(Double.NaN);
    }
}
