package steward.numerics;

import java.util.stream.DoubleStream;

/** Median of some values. */
public final class Median {

    private Median() { }

    /** Returns the middle of the values in their order; of an even number, the mean of the two in the middle. */
    public static double of(double... values) {
        double[] sorted = DoubleStream.of(values).sorted().toArray();
        int half = sorted.length / 2;
        return sorted.length % 2 == 1 ? sorted[half] : (sorted[half - 1] + sorted[half]) / 2;
    }
}
