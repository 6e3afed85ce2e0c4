package steward.game.podrace.simulator;

import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
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
import steward.game.podrace.PodRace;
import steward.game.podrace.PodState;
import steward.game.podrace.protocol.PodRaceType;
import steward.numerics.SplitMix64;
import steward.physics.event.EventAdvance;
import steward.scene.SceneFiles;
import steward.scene.SceneReader;
import steward.scene.SceneText;

/**
 * The official turn of four pods by every implementation, all with the same bits:
 * {@code ./gradlew jmh -Pbench=PodKernel}. One operation is one turn, from a given state that is set (or copied) first;
 * {@code states} measures only the setting.
 *
 * <p>{@code race}: turns of four pods on an official map, each steered at its next checkpoint less three times its
 * speed, and up to 500 u beside it; {@code brawl}: each is steered at another pod. A start every 100 turns.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(3)
@Warmup(iterations = 5, time = 1)
@Measurement(iterations = 5, time = 1)
public class PodKernelBenchmark {

    private static final int STATES = 256;
    private static final double[][] MAP = {{12460, 1350}, {10540, 5980}, {3580, 5180}, {13580, 7600}};

    @Param({"race", "brawl"})
    String crowd;

    private final PodRaceSimulator[] states = new PodRaceSimulator[STATES];
    private final PodCommands[] commands = new PodCommands[STATES];
    private final PodState[][] pods = new PodState[STATES][4];
    private final PodRaceSimulator simulator = new PodRaceSimulator(MAP);
    private final TextbookPodRace textbook = new TextbookPodRace(MAP, 4);
    private PodRaceType.PodRaceSetup setup;
    private EventAdvance plain;

    @Setup
    public void fill() {
        SceneText text = SceneFiles.load("mad-pod-racing");
        setup = new PodRaceType().open(SceneReader.read(text.text(), text.source()));
        plain = new EventAdvance(setup.plan().physics(null));
        SplitMix64 random = new SplitMix64(1);
        PodRaceSimulator race = new PodRaceSimulator(MAP);
        for (int k = 0; k < STATES; k++) {
            if (k % 100 == 0) {
                race = new PodRaceSimulator(MAP);
            }
            states[k] = new PodRaceSimulator(MAP);
            states[k].copyFrom(race);
            commands[k] = new PodCommands(4);
            for (int pod = 0; pod < 4; pod++) {
                pods[k][pod] = new PodState(race.x(pod), race.y(pod), race.vx(pod), race.vy(pod), race.heading(pod),
                    race.shieldTimer(pod), race.boostLeft(pod), race.passed(pod));
                command(race, pod, random, commands[k], k);
            }
            race.play(commands[k]);
        }
    }

    private void command(PodRaceSimulator race, int pod, SplitMix64 random, PodCommands to, int turn) {
        int thrust = random.nextInt(3) == 0 ? random.nextInt(0, 200) : 200;
        int enemy = (pod + 2 + turn / 20) % 4;
        enemy = enemy == pod ? (pod + 1) % 4 : enemy;
        int next = race.nextCheckpoint(pod);
        double dx = random.nextInt(-500, 500) - 3 * race.vx(pod);
        double dy = random.nextInt(-500, 500) - 3 * race.vy(pod);
        if (crowd.equals("race")) {
            to.set(pod, race.checkpointX(next) + dx, race.checkpointY(next) + dy, thrust);
        } else {
            to.set(pod, race.x(enemy), race.y(enemy), thrust);
        }
    }

    /** {@link TextbookPodRace}: objects, every angle computed. */
    @Benchmark
    @OperationsPerInvocation(STATES)
    public double textbook() {
        double sum = 0;
        for (int k = 0; k < STATES; k++) {
            for (int pod = 0; pod < 4; pod++) {
                PodState from = pods[k][pod];
                TextbookPodRace.Pod to = textbook.pod(pod);
                to.x = from.x();
                to.y = from.y();
                to.vx = from.vx();
                to.vy = from.vy();
                to.heading = from.heading();
                to.shieldTimer = from.shieldTimer();
                to.mass = from.shieldTimer() == 4 ? 10 : 1;
                to.boostLeft = from.boostLeft();
                to.passed = from.passed();
            }
            textbook.play(commands[k].targetX, commands[k].targetY, commands[k].thrust);
            sum += textbook.pod(0).x;
        }
        return sum;
    }

    /** {@link PodRace} with the event loop that is available to every scene. */
    @Benchmark
    @OperationsPerInvocation(STATES)
    public double plain() {
        return play(() -> new PodRace(setup.settings(), setup.scene(), setup.plan(), MAP, plain));
    }

    /** {@link PodRace} as matches and verification use it. */
    @Benchmark
    @OperationsPerInvocation(STATES)
    public double match() {
        return play(() -> setup.create(MAP));
    }

    private double play(Supplier<PodRace> fresh) {
        PodRace race = fresh.get();
        double sum = 0;
        for (int k = 0; k < STATES; k++) {
            for (int pod = 0; pod < 4; pod++) {
                race.setPod(pod, pods[k][pod]);
                race.command(pod, commands[k].targetX(pod), commands[k].targetY(pod), commands[k].thrust(pod));
            }
            race.play();
            sum += race.bodies().x[0];
            if (race.isOver()) {
                race = fresh.get();
            }
        }
        return sum;
    }

    /** {@link PodRaceSimulator}. */
    @Benchmark
    @OperationsPerInvocation(STATES)
    public double simulator() {
        double sum = 0;
        for (int k = 0; k < STATES; k++) {
            simulator.copyFrom(states[k]);
            simulator.play(commands[k]);
            sum += simulator.x(0);
        }
        return sum;
    }

    /** Only copies a state into a {@link PodRaceSimulator}. */
    @Benchmark
    @OperationsPerInvocation(STATES)
    public double states() {
        double sum = 0;
        for (int k = 0; k < STATES; k++) {
            simulator.copyFrom(states[k]);
            sum += simulator.x(0);
        }
        return sum;
    }
}
