package steward.game.podrace.simulator;

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
 * Price of a turn to a bot that searches by random playouts: every pod turns by 18 degrees to a random side and
 * thrusts, {@code ./gradlew jmh -Pbench=PodPlayout}. One operation is one turn of four pods, with its commands; a state
 * is copied every eight turns.
 *
 * <p>{@code target25}: by a target 25 degrees aside, out of reach; {@code target18}: by one 18 degrees aside, where
 * only the exact heading tells whether it is reached; {@code turn18}: by {@link PodCommands#turn}. All three play the
 * same games, {@code target18} up to a rounding. {@code c1}: without the optimizing compiler, as a bot runs that is
 * started with {@code -XX:TieredStopAtLevel=1}.
 *
 * <p>On a machine with other work, compare the shortest times, p0.00 of
 * {@code ./gradlew jmh -Pbench='PodPlayout -bm sample -f 1'}: of many invocations of 2,048 turns
 * some are never interrupted.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(3)
@Warmup(iterations = 5, time = 1)
@Measurement(iterations = 5, time = 1)
public class PodPlayoutBenchmark {

    private static final int PLAYOUTS = 256;
    private static final int TURNS = 8;
    private static final int PODS = 4;
    private static final double AWAY = 10_000;
    private static final double[][] MAP = {{12460, 1350}, {10540, 5980}, {3580, 5180}, {13580, 7600}};

    @Param({"target25", "target18", "turn18"})
    String command;

    private final PodRaceSimulator[] starts = new PodRaceSimulator[PLAYOUTS];
    private final PodRaceSimulator race = new PodRaceSimulator(MAP);
    private final PodCommands commands = new PodCommands(PODS);
    /** Per playout, turn and pod. */
    private final byte[] sides = new byte[PLAYOUTS * TURNS * PODS];
    private final int[] thrusts = new int[PLAYOUTS * TURNS * PODS];
    private double cosine;
    private double sine;

    @Setup
    public void fill() {
        SplitMix64 random = new SplitMix64(1);
        for (int k = 0; k < PLAYOUTS; k++) {
            starts[k] = new PodRaceSimulator(MAP);
            for (int pod = 0; pod < PODS; pod++) {
                starts[k].setPod(pod, random.nextInt(0, 16000), random.nextInt(0, 9000), random.nextInt(-400, 400),
                    random.nextInt(-400, 400), random.nextDouble() * 2 * Math.PI, 0, true, random.nextInt(0, 11));
            }
        }
        for (int k = 0; k < sides.length; k++) {
            sides[k] = (byte) (2 * random.nextInt(2) - 1);
            thrusts[k] = random.nextInt(3) == 0 ? random.nextInt(0, 200) : 200;
        }
        double degrees = command.equals("target25") ? 25 : 18;
        cosine = Math.cos(Math.toRadians(degrees));
        sine = Math.sin(Math.toRadians(degrees));
    }

    @Benchmark
    @OperationsPerInvocation(PLAYOUTS * TURNS)
    public double playout() {
        return play();
    }

    @Benchmark
    @OperationsPerInvocation(PLAYOUTS * TURNS)
    @Fork(value = 1, jvmArgsAppend = "-XX:TieredStopAtLevel=1")
    public double c1() {
        return play();
    }

    private double play() {
        return command.equals("turn18") ? byAngle() : byTarget();
    }

    private double byTarget() {
        double sum = 0;
        int at = 0;
        for (PodRaceSimulator start : starts) {
            race.copyFrom(start);
            for (int turn = 0; turn < TURNS; turn++) {
                for (int pod = 0; pod < PODS; pod++, at++) {
                    double x = race.directionX(pod);
                    double y = race.directionY(pod);
                    double across = sine * sides[at];
                    commands.set(pod, race.x(pod) + AWAY * (x * cosine - y * across),
                        race.y(pod) + AWAY * (x * across + y * cosine), thrusts[at]);
                }
                race.play(commands);
            }
            sum += race.x(0);
        }
        return sum;
    }

    private double byAngle() {
        double sum = 0;
        int at = 0;
        for (PodRaceSimulator start : starts) {
            race.copyFrom(start);
            for (int turn = 0; turn < TURNS; turn++) {
                for (int pod = 0; pod < PODS; pod++, at++) {
                    commands.turn(pod, PodCommands.GREATEST_TURN * sides[at], thrusts[at]);
                }
                race.play(commands);
            }
            sum += race.x(0);
        }
        return sum;
    }
}
