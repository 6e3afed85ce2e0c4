package steward.physics;

import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import steward.numerics.SplitMix64;

/**
 * What one circle-circle time of impact costs, in either arithmetic: {@code ./gradlew jmh -Pbench=TimeOfImpact}.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(3)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class TimeOfImpactBenchmark {

    private static final int PAIRS = 4096;
    private static final double TOUCH = 800;

    @Param
    Arithmetic arithmetic;

    private final double[] numbers = new double[4 * PAIRS];

    /** Pairs a few radii apart, most of them approaching, about a third of them hitting. */
    @Setup
    public void fill() {
        SplitMix64 random = new SplitMix64(1);
        for (int k = 0; k < PAIRS; k++) {
            double dx = (random.nextDouble() - 0.5) * 6000;
            double dy = (random.nextDouble() - 0.5) * 6000;
            numbers[4 * k] = dx;
            numbers[4 * k + 1] = dy;
            numbers[4 * k + 2] = -dx + (random.nextDouble() - 0.5) * 3000;
            numbers[4 * k + 3] = -dy + (random.nextDouble() - 0.5) * 3000;
        }
    }

    @Benchmark
    @OperationsPerInvocation(PAIRS)
    public double circles() {
        double sum = 0;
        for (int k = 0; k < numbers.length; k += 4) {
            double time = arithmetic.circles(numbers[k], numbers[k + 1], numbers[k + 2], numbers[k + 3], TOUCH);
            sum += time < 1 ? time : 0;
        }
        return sum;
    }
}
