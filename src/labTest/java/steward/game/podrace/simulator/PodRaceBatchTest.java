package steward.game.podrace.simulator;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.lang.reflect.Field;
import java.util.Set;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;
import org.junit.jupiter.api.parallel.Isolated;
import steward.game.podrace.PodState;
import steward.numerics.SplitMix64;

/** A batch against the simulator, game by game, bit for bit, on random states of every sort; and with threads. */
@Isolated("counts what other threads allocate")
class PodRaceBatchTest {

    private static final int GAMES = 300;
    private static final long SEED = Long.getLong("steward.seed", 11);
    private static final int ROUNDS = (int) (Long.getLong("steward.turns", 120_000) / GAMES / 4);

    private final RandomTurns random = new RandomTurns(SEED);
    private final double[][] map = {{3000, 3000}, {9000, 2000}, {12000, 7000}, {5000, 6500}};
    private final PodRaceSimulator[] games = new PodRaceSimulator[GAMES];
    private final PodRaceBatch batch = new PodRaceBatch(map, GAMES);
    private final PodRaceBatch.Commands commands = new PodRaceBatch.Commands(GAMES);

    @Test
    void everyGameIsThatOfASimulator(TestReporter report) {
        compareGames(Long.getLong("steward.turns") == null ? ROUNDS / 6 : ROUNDS, report);
    }

    @Test
    @Tag("campaign")
    void inManyRoundsEveryGameIsThatOfASimulator(TestReporter report) {
        compareGames(ROUNDS, report);
    }

    private void compareGames(int rounds, TestReporter report) {
        report.publishEntry("seed " + SEED + ", " + rounds * 4L * GAMES + " turns in batches");
        PodRaceSimulator found = new PodRaceSimulator(map);
        for (int round = 0; round < rounds; round++) {
            fill(round % 2 == 0);
            for (int turn = 0; turn < 4; turn++) {
                for (int game = 0; game < GAMES; game++) {
                    draw(game);
                    games[game].play(random.commands);
                }
                batch.play(commands);
                for (int game = 0; game < GAMES; game++) {
                    batch.get(game, found);
                    compare(games[game], found, "round " + round + " turn " + turn + " game " + game);
                    assertEquals(found.toNext(1), batch.toNext(game, 1));
                    assertEquals(found.passed(2), batch.passed(game, 2));
                }
            }
        }
    }

    /** Games that go on from the start by plain racing, or from random states. */
    private void fill(boolean anew) {
        for (int game = 0; game < GAMES; game++) {
            if (anew || games[game] == null) {
                random.state();
                games[game] = new PodRaceSimulator(map);
                if (game % 2 == 0) {
                    random.put(games[game]);
                }
            }
            batch.set(game, games[game]);
        }
    }

    private void draw(int game) {
        double[] x = new double[4];
        double[] y = new double[4];
        double[] heading = new double[4];
        for (int pod = 0; pod < 4; pod++) {
            x[pod] = games[game].x(pod);
            y[pod] = games[game].y(pod);
            heading[pod] = Math.atan2(games[game].directionY(pod), games[game].directionX(pod));
        }
        random.commands(x, y, heading);
        for (int pod = 0; pod < 4; pod++) {
            commands.set(game, pod, random.commands.targetX(pod), random.commands.targetY(pod),
                random.commands.thrust(pod));
        }
    }

    private static void compare(PodRaceSimulator expected, PodRaceSimulator found, String where) {
        for (int pod = 0; pod < 4; pod++) {
            assertEquals(state(expected, pod), state(found, pod), where);
            assertEquals(expected.nextCheckpoint(pod), found.nextCheckpoint(pod), where);
        }
        assertEquals(expected.turnsLeft(0), found.turnsLeft(0), where);
        assertEquals(expected.turnsLeft(1), found.turnsLeft(1), where);
    }

    private static PodState state(PodRaceSimulator race, int pod) {
        return new PodState(race.x(pod), race.y(pod), race.vx(pod), race.vy(pod), race.heading(pod),
            race.shieldTimer(pod), race.boostLeft(pod), race.passed(pod));
    }

    @Test
    void theNumberOfThreadsChangesNothing() {
        long one = hashAfterARace(1);
        assertEquals(one, hashAfterARace(2));
        assertEquals(one, hashAfterARace(3));
        assertEquals(one, hashAfterARace(1000));
    }

    private long hashAfterARace(int threads) {
        PodRaceBatch race = new PodRaceBatch(map, GAMES);
        SplitMix64 random = new SplitMix64(SEED);
        long hash = 0;
        try (ParallelBatch parallel = new ParallelBatch(race, threads)) {
            for (int turn = 0; turn < 60; turn++) {
                steer(race, random);
                parallel.play(commands);
            }
        }
        int passed = 0;
        for (int game = 0; game < GAMES; game++) {
            for (int pod = 0; pod < 4; pod++) {
                hash = SplitMix64.mix(hash + Double.doubleToLongBits(race.x(game, pod)));
                hash = SplitMix64.mix(hash + Double.doubleToLongBits(race.y(game, pod)));
                passed += race.passed(game, pod);
            }
        }
        assertTrue(passed > GAMES, "they race");
        return hash;
    }

    private void steer(PodRaceBatch race, SplitMix64 random) {
        for (int game = 0; game < GAMES; game++) {
            for (int pod = 0; pod < 4; pod++) {
                double[] goal = map[(race.passed(game, pod) + 1) % map.length];
                commands.set(game, pod, goal[0] - 3 * race.vx(game, pod) + random.nextInt(-500, 500),
                    goal[1] - 3 * race.vy(game, pod) + random.nextInt(-500, 500), 200);
            }
        }
    }

    @Test
    void aTurnAllocatesNothing() {
        fill(true);
        assertAllocatesNothing(() -> batch.play(commands));
    }

    /** Neither in the caller's thread nor in the others. */
    @Test
    void aTurnOnManyThreadsAllocatesNothing() {
        fill(true);
        try (ParallelBatch parallel = new ParallelBatch(batch, 3)) {
            assertEquals(3, parallel.threads());
            assertAllocatesNothing(() -> parallel.play(commands));
        }
    }

    /** Once the buffers have grown and the JVM has compiled the code. */
    private void assertAllocatesNothing(Runnable turn) {
        for (int game = 0; game < GAMES; game++) {
            draw(game);
        }
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long[] others = Thread.getAllStackTraces().keySet().stream()
            .filter(thread -> thread.getName().startsWith("pod-race-batch-")).mapToLong(Thread::getId).toArray();
        long allocated = Long.MAX_VALUE;
        for (int count = 0; count < 20 && allocated > 0; count++) {
            fill(true);
            long[] before = threads.getThreadAllocatedBytes(others);
            long own = threads.getCurrentThreadAllocatedBytes();
            for (int k = 0; k < 20; k++) {
                turn.run();
            }
            own = threads.getCurrentThreadAllocatedBytes() - own;
            long[] after = threads.getThreadAllocatedBytes(others);
            allocated = own;
            for (int k = 0; k < others.length; k++) {
                allocated += after[k] < 0 ? 0 : after[k] - before[k];      // one of an earlier batch has just ended
            }
        }
        assertEquals(0, allocated, "bytes in 20 turns of " + GAMES + " games");
    }

    @Test
    void aThreadThatIsInterruptedFinishesTheTurn() {
        try (ParallelBatch parallel = new ParallelBatch(batch, 3)) {
            Thread.currentThread().interrupt();
            for (int turn = 0; turn < 10; turn++) {
                parallel.play(commands);
            }
            assertTrue(Thread.interrupted());
        }
        assertEquals(90, batch.turnsLeft(GAMES - 1, 1));
    }

    /** It sleeps where nobody asks for a turn, and is woken by the next one. */
    @Test
    void aThreadThatSleepsIsWoken() throws InterruptedException {
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        fill(true);
        Set<Thread> ofOthers = Thread.getAllStackTraces().keySet();
        try (ParallelBatch parallel = new ParallelBatch(batch, 2)) {
            Thread helper = Thread.getAllStackTraces().keySet().stream().filter(thread -> !ofOthers.contains(thread)
                && thread.getName().startsWith("pod-race-batch-")).findFirst().orElseThrow();
            for (int turn = 0; turn < 3; turn++) {
                await("it does not go to sleep", () -> helper.getState() == Thread.State.WAITING);
                long before = threads.getThreadCpuTime(helper.getId());
                parallel.play(commands);
                await("nobody woke it", () -> threads.getThreadCpuTime(helper.getId()) > before);
            }
        }
    }

    /** Half a minute at least, by looks: time in which the whole machine stands still is no one's fault. */
    private static void await(String otherwise, BooleanSupplier condition) throws InterruptedException {
        for (int look = 0; !condition.getAsBoolean(); look++) {
            assertTrue(look < 30_000, otherwise);
            Thread.sleep(1);
        }
    }

    /** Also where another thread meets it; the next turn is played as ever. */
    @Test
    void whatGoesWrongInAGameIsTold() throws ReflectiveOperationException {
        Field field = PodRaceBatch.class.getDeclaredField("states");
        field.setAccessible(true);
        double[][] states = (double[][]) field.get(batch);
        try (ParallelBatch parallel = new ParallelBatch(batch, 2)) {
            for (int game : new int[] {0, GAMES / 2, GAMES - 1}) {
                double[] state = states[game];
                states[game] = null;
                assertThrows(IllegalStateException.class, () -> parallel.play(commands), "game " + game);
                states[game] = state;
                int before = batch.turnsLeft(0, 1);
                parallel.play(commands);
                assertEquals(before - 1, batch.turnsLeft(0, 1));
            }
        }
    }

    @Test
    void refusesWhatCannotBe() {
        assertRefused("0 games", () -> new PodRaceBatch(map, 0));
        assertRefused("0 games", () -> new PodRaceBatch.Commands(0));
        assertRefused("0 threads", () -> new ParallelBatch(batch, 0));
        assertRefused("100000 threads", () -> new ParallelBatch(batch, 100_000));
        assertRefused("commands for 7 games, expected 300", () -> batch.play(new PodRaceBatch.Commands(7)));
        assertRefused("thrust 651", () -> commands.set(0, 0, 0, 0, 651));
        assertRefused("target NaN", () -> commands.set(0, 0, Double.NaN, 0, 1));
        assertThrows(IndexOutOfBoundsException.class, () -> commands.set(0, 4, 0, 0, 1));
        assertThrows(IndexOutOfBoundsException.class, () -> commands.set(1 << 30, 0, 0, 0, 1), "4 times that is 0");
        assertThrows(IndexOutOfBoundsException.class, () -> batch.turnsLeft(0, -1));
        assertRefused("a race of 2 pods", () -> batch.set(0, new PodRaceSimulator(map, 2, 1, 3)));
        assertRefused("with 2 checkpoints", () -> batch.get(0, new PodRaceSimulator(new double[][] {{0, 0}, {9, 9}})));
        ParallelBatch closed = new ParallelBatch(batch, 2);
        closed.close();
        assertThrows(IllegalStateException.class, () -> closed.play(commands));
    }

    private static void assertRefused(String said, org.junit.jupiter.api.function.Executable call) {
        String message = assertThrows(IllegalArgumentException.class, call).getMessage();
        assertTrue(message.contains(said), message);
    }

    /** The caller may do with his array what he likes. */
    @Test
    void theMapIsCopied() {
        double[][] places = {{3000, 3000}, {9000, 2000}};
        PodRaceBatch race = new PodRaceBatch(places, 1);
        double before = race.toNext(0, 0);
        places[1][0] = 0;
        assertEquals(before, race.toNext(0, 0));
    }
}
