package steward.game.podrace.simulator;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.function.Supplier;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.game.podrace.PodRace;
import steward.game.podrace.PodState;
import steward.game.podrace.Races;
import steward.game.podrace.protocol.PodRaceType;
import steward.match.TestScenes;
import steward.match.TestSize;
import steward.physics.event.Scenes;
import steward.scene.SceneReader;

/**
 * The simulator against the plain kernel on {@link EdgeTurns}, for one player up to as many as fit: every number and
 * every impact, bit for bit. 2,500 turns each, or what the system property {@code steward.turns} says; with many pods a
 * tenth of them.
 */
@Execution(ExecutionMode.CONCURRENT)
class PodTurnEdgesTest {

    private static final long TURNS = Long.getLong("steward.turns", 2_500);
    private static final long SEED = Long.getLong("steward.seed", 8);
    private static final double[][] MAP = {{3000, 3000}, {0, 0}, {32768, 700}, {0, 0}, {8000, 0}};

    private static PodRaceType.PodRaceSetup setup(int players, int podsPerPlayer) {
        return new PodRaceType().open(SceneReader.read(TestScenes.text("mad-pod-racing")
            .replace("\"players\": 2", "\"players\": " + players)
            .replace("\"perPlayer\": 2", "\"perPlayer\": " + podsPerPlayer), "mad-pod-racing"));
    }

    @ParameterizedTest
    @Tag("slow")
    @CsvSource({"2, 2", "1, 1", "2, 1", "1, 2", "3, 2"})
    void everyBitIsThatOfThePlainKernel(int players, int podsPerPlayer, TestReporter report) {
        compareTurns(players, podsPerPlayer, TURNS, report);
    }

    @ParameterizedTest
    @CsvSource({"5, 2", "8, 1"})
    @Tag("sized")
    void everyBitOfManyPodsIsThatOfThePlainKernel(int players, int podsPerPlayer, TestReporter report) {
        compareTurns(players, podsPerPlayer, TURNS / TestSize.of(10, 1), report);
    }

    private static void compareTurns(int players, int podsPerPlayer, long most, TestReporter report) {
        int pods = players * podsPerPlayer;
        PodRaceType.PodRaceSetup setup = setup(players, podsPerPlayer);
        PodRaceSimulator fast = new PodRaceSimulator(MAP, players, podsPerPlayer, 3);
        EdgeTurns edges = new EdgeTurns(SEED + pods, pods);
        long impacts = 0;
        long limited = 0;
        for (long turns = 0; turns < most;) {
            PodRace plain = Races.plain(setup, MAP);
            edges.state();
            boolean recorded = fast.x(0) % 2 == 0;
            fast.setRecorded(recorded);
            put(edges, plain, fast, setup.settings().turnsWithoutCheckpoint());
            String start = text(plain);
            for (int turn = edges.turns(); turn > 0 && !plain.isOver(); turn--, turns++) {
                edges.draw(plain);
                Races.give(plain, edges.commands);
                plain.play();
                fast.play(edges.commands);
                long number = turns;
                Supplier<String> where = () -> "turn " + number + " from " + start + commands(edges.commands, pods);
                compare(plain, fast, pods, where);
                if (recorded) {
                    Scenes.assertSameLog(plain.log(), fast.log(), where);
                }
                impacts += plain.log().impacts();
                limited += plain.log().limited() ? 1 : 0;
                if (plain.log().limited()) {
                    break;
                }
            }
        }
        report.publishEntry("seed " + SEED + ", " + pods + " pods: " + most + " turns at edges, " + impacts
            + " impacts, " + limited + " turns at the limit of impacts");
        assertTrue(pods == 1 || impacts > most / 10, "too little happened");
    }

    private static void put(EdgeTurns edges, PodRace plain, PodRaceSimulator fast, int turnsLeft) {
        for (int pod = 0; pod < fast.pods(); pod++) {
            plain.setPod(pod, new PodState(edges.x[pod], edges.y[pod], edges.vx[pod], edges.vy[pod], edges.heading[pod],
                edges.timer[pod], pod % 2 == 0, pod));
            Races.put(fast, pod, plain.pod(pod));
            fast.setTurnsLeft(fast.playerOf(pod), turnsLeft);
        }
    }

    private static void compare(PodRace plain, PodRaceSimulator fast, int pods, Supplier<String> where) {
        for (int k = 0; k < pods; k++) {
            // Every second time the recipe of a heading stays as it is, so that chains grow.
            double heading = k % 2 == 0 || plain.turn() % 2 == 0 ? plain.heading(k) : fast.heading(k);
            assertEquals(plain.pod(k), Races.state(fast, k, heading), where);
        }
        for (int player = 0; player < plain.players(); player++) {
            assertEquals(plain.turnsLeft(player), fast.turnsLeft(player), where);
        }
    }

    private static String text(PodRace race) {
        StringBuilder text = new StringBuilder();
        for (int pod = 0; pod < race.settings().pods(); pod++) {
            text.append('\n').append(race.pod(pod));
        }
        return text.toString();
    }

    private static String commands(PodCommands commands, int pods) {
        StringBuilder text = new StringBuilder("\nlast commands:");
        for (int pod = 0; pod < pods; pod++) {
            text.append(' ').append(Arrays.toString(new double[] {commands.targetX(pod), commands.targetY(pod),
                commands.thrust(pod)}));
        }
        return text.toString();
    }

    /** The plain kernel computes a turn with a speed of 4e-252 in more than doubles: its impacts differ in the end. */
    @Test
    void aHardlyPerceptibleSpeedIsComputedAsThePlainKernelDoes() {
        PodRaceType.PodRaceSetup setup = setup(2, 2);
        PodRace plain = Races.plain(setup, MAP);
        PodRaceSimulator fast = new PodRaceSimulator(MAP);
        fast.setRecorded(true);
        PodState[] pods = {new PodState(6, 0, 5, 2, 2.0849711874114156, 0, false, 14),
            new PodState(10, 0, -5, 0, Double.NaN, 0, true, 14), new PodState(10, 2, -2, -2, -0.0, 0, true, 11),
            new PodState(2, 6, -1, 5, 0.6283185307179586, 0, false, 9)};
        double[][] commands = {{6, 8743, 0}, {6.6499048351653E86, 3.1763072512977764E-167, 86}, {10, 2, 134},
            {9512.565162951536, 3096.169943749474, 189}};
        PodCommands given = new PodCommands(4);
        for (int pod = 0; pod < 4; pod++) {
            plain.setPod(pod, pods[pod]);
            Races.put(fast, pod, pods[pod]);
            given.set(pod, commands[pod][0], commands[pod][1], (int) commands[pod][2]);
        }

        Races.give(plain, given);
        plain.play();
        fast.play(given);

        assertTrue(plain.log().impacts() > 0);
        Scenes.assertSameLog(plain.log(), fast.log(), () -> "tiny speed");
    }
}
