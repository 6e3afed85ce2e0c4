package steward.game.podrace.simulator;

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
import steward.game.podrace.PodRace;
import steward.game.podrace.PodState;
import steward.game.podrace.protocol.PodRaceType;
import steward.numerics.SplitMix64;
import steward.scene.Accuracy;
import steward.scene.SceneFiles;
import steward.scene.SceneReader;
import steward.scene.SceneText;

/**
 * The cost of a whole turn of four pods from given states, impacts and checkpoints included:
 * {@code ./gradlew jmh -Pbench=PodTurn}. In {@code race} the pods are spread over the map, in {@code brawl} they crowd
 * around one place; {@code accuracy} is the rung.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(3)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class PodTurnBenchmark {

    private static final int STATES = 1024;
    private static final double FAR = 1e6;

    @Param({"race", "brawl"})
    String crowd;

    @Param({"event/official", "event/double", "event/compensated", "event/exact", "step/1", "step/4"})
    String accuracy;

    private PodRaceType.PodRaceSetup setup;
    private PodRace race;
    private PodState[] states;
    private int[] thrusts;
    private int next;

    @Setup
    public void fill() {
        SceneText text = SceneFiles.load("mad-pod-racing");
        Accuracy rung = Accuracy.parse(accuracy);
        String block = "\"advance\": \"" + rung.way().text() + "\", \"arithmetic\": \""
            + rung.arithmetic().text() + "\"" + (rung.steps() > 0 ? ", \"steps\": " + rung.steps() : "");
        setup = new PodRaceType().open(SceneReader.read(
            text.text().replaceFirst("\"accuracy\": *\\{[^}]*", "\"accuracy\": {" + block), text.source()));
        SplitMix64 random = new SplitMix64(1);
        double width = crowd.equals("race") ? 16000 : 2400;
        states = new PodState[4 * STATES];
        thrusts = new int[4 * STATES];
        for (int k = 0; k < states.length; k++) {
            states[k] = new PodState(random.nextInt((int) width), random.nextInt((int) width * 9 / 16),
                random.nextInt(-500, 500), random.nextInt(-500, 500), random.nextDouble() * 6, 0, true, 0);
            thrusts[k] = random.nextInt(0, 200);
        }
    }

    /**
     * The limit on turns without a checkpoint ends a race; a new one costs as much as a turn, once in a hundred turns.
     */
    @Benchmark
    public double turn() {
        if (race == null || race.isOver()) {
            race = setup.create(new double[][] {{-FAR, -FAR}, {FAR, FAR}});
        }
        for (int pod = 0; pod < 4; pod++) {
            int k = 4 * next + pod;
            race.setPod(pod, states[k]);
            race.command(pod, states[(k + 1) % states.length].x(), states[(k + 2) % states.length].y(), thrusts[k]);
        }
        next = (next + 1) % STATES;
        race.play();
        return race.bodies().x[0];
    }
}
