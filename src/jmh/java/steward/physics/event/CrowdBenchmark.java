package steward.physics.event;

import java.util.List;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
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

/**
 * The cost of a turn of many bodies in a box on each rung, always the same 16 turns from the start:
 * {@code ./gradlew jmh -Pbench=Crowd}.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Fork(3)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class CrowdBenchmark {

    private static final int TURNS = 16;

    @Param({"OFFICIAL", "DOUBLE", "COMPENSATED", "EXACT", "step/1", "step/8"})
    String rung;

    @Param({"9", "49"})
    int bodies;

    private Bodies start;
    private Bodies now;
    private Advance advance;
    private int turn;

    /** Two fifths of the box are covered. */
    @Setup
    public void fill() {
        int perRow = (int) Math.sqrt(bodies);
        SplitMix64 random = new SplitMix64(1);
        start = new Bodies(bodies);
        now = new Bodies(bodies);
        for (int k = 0; k < bodies; k++) {
            start.add((k % perRow + 0.5) * 1000, (k / perRow + 0.5) * 1000, 360, 1 + random.nextInt(3));
            start.setVelocity(k, random.nextInt(-600, 600), random.nextInt(-600, 600));
        }
        boolean steps = rung.startsWith("step/");
        PhysicsParts parts = new PhysicsParts(ImpactLaw.PHYSICS, steps ? Arithmetic.DOUBLE : Arithmetic.valueOf(rung),
            new Contacts(1), List.of(Wall.box(perRow * 1000.0, perRow * 1000.0, 1)), null, false);
        advance = steps ? new StepAdvance(parts, Integer.parseInt(rung.substring(5))) : new EventAdvance(parts);
    }

    @Benchmark
    public double turn() {
        if (turn++ % TURNS == 0) {
            now.copyFrom(start);
        }
        advance.turn(now, TurnSink.NONE);
        return now.x[0];
    }
}
