package steward.physics.time;

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
import steward.numerics.DoubleDouble;
import steward.numerics.SplitMix64;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;

/**
 * The cost of computing the time of impact of one pair, in every arithmetic; in {@code EXACT} that is the lower bound
 * with its exact decision, and {@code exactTimes} is the exact time, needed only for impacts that happen:
 * {@code ./gradlew jmh -Pbench=TimeOfImpact}.
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

    private final Bodies bodies = new Bodies(2 * PAIRS);
    private final DoubleDouble exactTime = new DoubleDouble();
    private final ExactPairs exact = new ExactPairs(ImpactLaw.PHYSICS);
    private PairTime pairs;

    /** Pairs a few radii apart, most of them approaching, about a third of them hitting. */
    @Setup
    public void fill() {
        SplitMix64 random = new SplitMix64(1);
        for (int k = 0; k < PAIRS; k++) {
            double dx = (random.nextDouble() - 0.5) * 6000;
            double dy = (random.nextDouble() - 0.5) * 6000;
            bodies.add(dx, dy, TOUCH / 2, 1);
            bodies.add(0, 0, TOUCH / 2, 1);
            bodies.setVelocity(2 * k, -dx + (random.nextDouble() - 0.5) * 3000,
                -dy + (random.nextDouble() - 0.5) * 3000);
        }
        pairs = arithmetic == Arithmetic.EXACT ? exact : PairTime.of(ImpactLaw.PHYSICS, arithmetic);
    }

    @Benchmark
    @OperationsPerInvocation(PAIRS)
    public double circles() {
        double sum = 0;
        for (int k = 0; k < 2 * PAIRS; k += 2) {
            double time = pairs.until(bodies, k, k + 1, bodies.radius[k], bodies.radius[k + 1]);
            sum += time < 1 ? time : 0;
        }
        return sum;
    }

    @Benchmark
    @OperationsPerInvocation(PAIRS)
    public double exactTimes() {
        double sum = 0;
        for (int k = 0; k < 2 * PAIRS; k += 2) {
            sum += exact.exactTime(bodies, k, k + 1, exactTime) ? exactTime.high() : 0;
        }
        return sum;
    }
}
