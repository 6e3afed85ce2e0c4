package steward.physics.time;

import java.util.List;
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
import steward.physics.Advance;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.TurnSink;
import steward.physics.Wall;
import steward.physics.event.EventAdvance;

/**
 * The cost of a turn of 25 discs in a box with the processor's fused multiply-add and without, where products are split
 * instead ({@link steward.numerics.ErrorFree}); {@code Math.fma} alone would take microseconds there:
 * {@code ./gradlew jmh -Pbench=Fma}.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class FmaBenchmark {

    private static final int WORLDS = 64;
    private static final double SIDE = 1000;

    @Param({"DOUBLE", "COMPENSATED", "EXACT"})
    Arithmetic arithmetic;

    private final Bodies[] starts = new Bodies[WORLDS];
    private final Bodies bodies = new Bodies(25);
    private Advance advance;

    /** Some dozens of impacts a turn. */
    @Setup
    public void fill() {
        SplitMix64 random = new SplitMix64(1);
        for (int world = 0; world < WORLDS; world++) {
            starts[world] = new Bodies(25);
            for (int k = 0; k < 25; k++) {
                starts[world].add(200 * (k % 5) + 60 + 80 * random.nextDouble(),
                    200 * (k / 5) + 60 + 80 * random.nextDouble(), 50, 1 + random.nextDouble());
                starts[world].setVelocity(k, 600 * (random.nextDouble() - 0.5), 600 * (random.nextDouble() - 0.5));
            }
        }
        advance = new EventAdvance(new PhysicsParts(ImpactLaw.PHYSICS, arithmetic, new Contacts(1),
            List.of(Wall.box(SIDE, SIDE, 1)), null, false));
    }

    @Benchmark
    @OperationsPerInvocation(WORLDS)
    public double fused() {
        return play();
    }

    @Benchmark
    @Fork(value = 1, jvmArgsAppend = "-XX:-UseFMA")
    @OperationsPerInvocation(WORLDS)
    public double split() {
        return play();
    }

    private double play() {
        double sum = 0;
        for (Bodies start : starts) {
            bodies.copyFrom(start);
            advance.turn(bodies, TurnSink.NONE);
            sum += bodies.x[0];
        }
        return sum;
    }
}
