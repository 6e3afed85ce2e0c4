package steward.numerics;

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

/**
 * Price of sine and cosine of one angle together, correctly rounded and as {@code StrictMath} has them: {@code
 * ./gradlew jmh -Pbench=SineCosine}. The angles: {@code heading}, from 0 to 2 pi; {@code turned}, headings that were
 * never normalised, from -100 to 100; {@code far}, up to 10^6; {@code axis}, the doubles next to pi/2, pi and 3 pi/2,
 * where the series of {@link SineCosine} is needed, but few of its terms.
 *
 * <p>{@code ...InTurn}: each angle waits for the results of the one before.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(3)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class SineCosineBenchmark {

    private static final int ANGLES = 1024;
    /** Results times this, added to an angle, change nothing. */
    private static final double NOTHING = 0x1p-200;

    @Param({"heading", "turned", "far", "axis"})
    String range;

    private final double[] angles = new double[ANGLES];
    private final SineCosine rounded = new SineCosine();
    private final SineCosine bySeries = new SineCosine(Double.POSITIVE_INFINITY);

    @Setup
    public void fill() {
        SplitMix64 random = new SplitMix64(1);
        for (int k = 0; k < ANGLES; k++) {
            angles[k] = switch (range) {
                case "heading" -> random.nextDouble() * 2 * Math.PI;
                case "turned" -> (random.nextDouble() - 0.5) * 200;
                case "far" -> (random.nextDouble() - 0.5) * 2e6;
                default -> random.nextInt(1, 3) * (Math.PI / 2);
            };
        }
    }

    /** {@link SineCosine}. */
    @Benchmark
    @OperationsPerInvocation(ANGLES)
    public double rounded() {
        double sum = 0;
        for (double angle : angles) {
            rounded.turn(angle);
            sum += rounded.cos() + rounded.sin();
        }
        return sum;
    }

    @Benchmark
    @OperationsPerInvocation(ANGLES)
    public double roundedInTurn() {
        double before = 0;
        for (double angle : angles) {
            rounded.turn(angle + before * NOTHING);
            before = rounded.cos() + rounded.sin();
        }
        return before;
    }

    /** {@code StrictMath} itself. */
    @Benchmark
    @OperationsPerInvocation(ANGLES)
    public double library() {
        double sum = 0;
        for (double angle : angles) {
            sum += StrictMath.cos(angle) + StrictMath.sin(angle);
        }
        return sum;
    }

    /** All of it by {@link SineCosineSeries}. */
    @Benchmark
    @OperationsPerInvocation(ANGLES)
    public double bySeries() {
        double sum = 0;
        for (double angle : angles) {
            bySeries.turn(angle);
            sum += bySeries.cos() + bySeries.sin();
        }
        return sum;
    }
}
