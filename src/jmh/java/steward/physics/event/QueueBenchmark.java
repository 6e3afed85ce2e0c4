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
import steward.lab.trial.Gas;
import steward.physics.Advance;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.TurnSink;

/**
 * The number of bodies from which a queue is faster than a scan of all pairs: a turn of a gas at 10% coverage, with
 * hardly any impact, half an impact a body, or ten. {@code ./gradlew jmh -Pbench=QueueBenchmark}. For larger numbers
 * with the queue:
 * {@code -Pbench='QueueBenchmark -p way=QUEUE -p impacts=MANY -p bodies=100,1000,10000,100000,1000000'}.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Fork(2)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class QueueBenchmark {

    /** Impacts in a turn, by how far bodies fly. */
    public enum Impacts {
        NONE(0.0005), FEW(0.05), MANY(1);

        private final double speed;

        Impacts(double speed) {
            this.speed = speed;
        }
    }

    /** Advance that is measured. */
    public enum Way { EVENT, QUEUE }

    @Param
    Way way;

    @Param
    Impacts impacts;

    @Param({"4", "8", "12", "16", "24", "32", "48"})
    int bodies;

    private Bodies gas;
    private Advance advance;

    @Setup
    public void fill() {
        Gas of = new Gas(1, bodies, 0.1);
        gas = of.bodies();
        for (int k = 0; k < bodies; k++) {
            gas.setVelocity(k, impacts.speed * gas.vx[k], impacts.speed * gas.vy[k]);
        }
        PhysicsParts parts = new PhysicsParts(ImpactLaw.PHYSICS, Arithmetic.DOUBLE, new Contacts(1),
            List.of(of.walls()), null, false);
        advance = way == Way.EVENT ? new EventAdvance(parts) : new QueueAdvance(parts);
    }

    @Benchmark
    public double turn() {
        advance.turn(gas, TurnSink.NONE);
        return gas.x[0];
    }
}
