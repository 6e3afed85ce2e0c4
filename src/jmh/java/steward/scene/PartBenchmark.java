package steward.scene;

import java.util.Arrays;
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
import steward.game.GameSetup;
import steward.game.GameTypes;
import steward.game.podrace.protocol.PodRaceType;
import steward.numerics.SplitMix64;
import steward.physics.Bodies;
import steward.physics.TurnLog;

/**
 * Price of each part of a turn, from an empty scene where bodies only fly, each in a JVM of its own: {@code ./gradlew
 * jmh -Pbench=Part}. The parts of a scene come first, each added to those before it; then the others, each added to the
 * whole scene. Every result includes the time of copying a state.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class PartBenchmark {

    private static final int STATES = 256;
    private static final int BODIES = 4;

    @Param({"mad-pod-racing", "walled-race"})
    String scene;

    @Param({PartByPartPhysics.EMPTY, "pair impacts", "walls", "restitution", "minimum impulse", "push-out",
        "batch window", "infinite masses", "drag", "velocity rounding", "position rounding", "reactions",
        "broad phase"})
    String part;

    private final TurnLog log = new TurnLog();
    private Bodies[] states;
    private Bodies now;
    private PartByPartPhysics.Step step;
    private int turn;

    /** Pods close enough to meet in some of the turns. */
    @Setup
    public void fill() {
        SceneText text = SceneFiles.load(scene);
        GameSetup setup = new GameTypes(List.of(new PodRaceType())).open(text.text(), text.source());
        SplitMix64 random = new SplitMix64(1);
        states = new Bodies[STATES];
        Arrays.setAll(states, k -> state(random));
        now = new Bodies(BODIES);
        step = PartByPartPhysics.of(setup).stream().filter(each -> each.part().equals(part)).findFirst()
            .orElseThrow();
    }

    private static Bodies state(SplitMix64 random) {
        Bodies bodies = new Bodies(BODIES);
        for (int k = 0; k < BODIES; k++) {
            bodies.add(random.nextInt(500, 6000), random.nextInt(500, 6000), 400, 1);
            bodies.setVelocity(k, random.nextInt(-500, 500), random.nextInt(-500, 500));
            bodies.setDrag(k, 0.15);
        }
        return bodies;
    }

    @Benchmark
    public double turn() {
        now.copyFrom(states[turn++ % STATES]);
        log.clear();
        step.advance().turn(now, log);
        step.motion().endTurn(now);
        return now.x[0];
    }
}
