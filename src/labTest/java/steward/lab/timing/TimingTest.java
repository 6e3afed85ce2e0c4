package steward.lab.timing;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import java.util.function.LongUnaryOperator;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import steward.physics.Bodies;
import steward.scene.Accuracy;

/** Rounds that go from place to place, what is said of them, work in this JVM, and a JVM that times for this one. */
@Isolated("counts the bytes of all threads")
class TimingTest {

    private static final TimingEffort EFFORT = new TimingEffort(2, 3, 0.5, 0.25, 4);
    private static final int NANOS_PER_MS = 1_000_000;

    /** A place that tells what it is asked to do, and takes as many nanoseconds as its list says, round by round. */
    private record Told(String name, Consumer<String> told, AtomicInteger rounds, double... nanos)
        implements TimedPlace {

        @Override
        public void warmUp(double least, double most) {
            told.accept(name + " warm " + least + " " + most);
        }

        @Override
        public Stretch round(double least) {
            told.accept(name + " round " + least);
            return new Stretch(nanos[rounds.getAndIncrement()], nanos.length);
        }

        @Override
        public void close() {
            told.accept(name + " closed");
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2})
    void roundsGoFromPlaceToPlaceAndBack(int atOnce) {
        List<String> told = Collections.synchronizedList(new ArrayList<>());
        Map<String, AtomicInteger> rounds = new ConcurrentHashMap<>();
        Timing<String> timing = new Timing<>(EFFORT, name -> new Told(name, told::add,
            rounds.computeIfAbsent(name, any -> new AtomicInteger()),
            name.equals("a") ? new double[] {10, 30, 20, 12, 11, 13} : new double[] {200, 240, 220, 210, 260, 230}),
            atOnce);
        AtomicInteger steps = new AtomicInteger();
        TimingSamples samples = timing.run(List.of("a", "b"), steps::incrementAndGet);
        assertEquals(timing.steps(2), steps.get());
        List<String> measured = told.stream().filter(line -> !line.contains("warm")).map(line -> line.substring(0, 3))
            .toList();
        List<String> repeat = List.of("a r", "b r", "b r", "a r", "a r", "b r", "a c", "b c");
        assertEquals(repeat, measured.subList(0, 8));
        assertEquals(repeat, measured.subList(8, 16));
        assertEquals(4, told.stream().filter(line -> line.endsWith("warm 0.25 4.0")).count());
        assertEquals(12.5, samples.median(0), "of all rounds");
        assertEquals(225, samples.median(1));
        assertEquals(225 / 12.5, samples.ratio(1, 0), "of the medians that are shown");
        assertArrayEquals(new double[] {8, 11, 17.5, 230 / 13.0, 20, 260 / 11.0}, samples.ratios(1, 0), "by round");
        assertArrayEquals(new double[] {20, 12}, samples.medians(0), "of each repeat");
        assertEquals(6, samples.bytes(0));
        assertEquals(6, samples.rounds());
        assertEquals(2, samples.repeats());
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2})
    void placesAreClosedWhenOneFails(int atOnce) {
        List<String> told = Collections.synchronizedList(new ArrayList<>());
        Timing<String> timing = new Timing<>(EFFORT, name -> {
            if (name.equals("b")) {
                throw new IllegalStateException("no b");
            }
            return new Told("a", told::add, new AtomicInteger(), 1, 2, 3);
        }, atOnce);
        assertEquals("no b", assertThrows(IllegalStateException.class,
            () -> timing.run(List.of("a", "b"), () -> { })).getMessage());
        assertEquals(told.stream().anyMatch(line -> line.contains("warm")) ? 1 : 0,
            told.stream().filter(line -> line.equals("a closed")).count(), told.toString());
    }

    /** Neither is warm before the other has begun. */
    @Test
    void placesInOtherJvmsAreWarmedUpTogether() {
        CountDownLatch both = new CountDownLatch(2);
        Timing<String> timing = new Timing<>(EFFORT, name -> new TimedPlace() {
            @Override
            public void warmUp(double least, double most) throws InterruptedException {
                both.countDown();
                assertTrue(both.await(1, TimeUnit.MINUTES), "the other does not begin");
            }

            @Override
            public Stretch round(double least) {
                return new Stretch(1, 0);
            }
        }, 2);
        assertEquals(6, timing.run(List.of("a", "b"), () -> { }).rounds());
    }

    /** Work whose pieces take so many nanoseconds by a clock of the test, which counts what they have taken so far. */
    private static final class Taking implements TimedWork {

        private final LongUnaryOperator nanos;
        private long spent;
        private int runs;

        Taking(LongUnaryOperator nanos) {
            this.nanos = nanos;
        }

        @Override
        public long run() {
            spent += nanos.applyAsLong(spent);
            runs++;
            return 1;
        }

        WorkClock clock() {
            return new WorkClock(() -> spent, () -> 3 * runs);
        }

        /** Warms up for up to ten seconds, while the compiler is at work for so many milliseconds, and measures. */
        double nanosWhenWarm(long compiling) throws Exception {
            WorkTimer timer = new WorkTimer(clock(), this, () -> Math.min(compiling, spent / NANOS_PER_MS));
            timer.warmUp(0.001, 10);
            assertEquals(3, timer.round(0.01).bytes(), "bytes of a unit");
            return timer.round(0.01).nanos();
        }
    }

    /** It becomes faster until 300 ms, and then is ten times as fast; or it is as slow until it has been compiled. */
    @Test
    void warmingUpGoesOnUntilTimesAreSteadyAndNothingIsCompiled() throws Exception {
        assertEquals(100_000, new Taking(spent -> spent < 300 * NANOS_PER_MS ? NANOS_PER_MS - spent / 400 : 100_000)
            .nanosWhenWarm(0));
        assertEquals(100_000, new Taking(spent -> spent < 300 * NANOS_PER_MS ? NANOS_PER_MS : 100_000)
            .nanosWhenWarm(300));
    }

    /** Each piece takes 5% longer than the one before, so after ten seconds by its clock, of 5% too much at most. */
    @Test
    void whatIsNeverSteadyIsGivenUp() throws Exception {
        Taking slower = new Taking(spent -> 1000 + spent / 20);
        new WorkTimer(slower.clock(), slower, () -> 0).warmUp(0.001, 10);
        assertEquals(10.25e9, slower.spent, 0.25e9);
        new WorkTimer(slower.clock(), slower, () -> 0).warmUp(0, 0);
        assertEquals(10.25e9, slower.spent, 0.25e9, "no time to become steady");
    }

    private static byte[] garbage;

    private static long allocate() {
        garbage = new byte[100_000];
        return 1;
    }

    /** By this thread or by another one that lives on; by the wall clock they are not counted. */
    @Test
    void bytesAreCountedInWhicheverThreadAllocates() throws Exception {
        ExecutorService other = Executors.newSingleThreadExecutor();
        try {
            assertEquals(100_000, new WorkTimer(TimingTest::allocate).round(0.01).bytes(), 5_000);
            assertEquals(100_000, new WorkTimer(WorkClock.JVM, () -> other.submit(TimingTest::allocate).get())
                .round(0.05).bytes(), 10_000);
            assertTrue(Double.isNaN(new WorkTimer(WorkClock.WALL, TimingTest::allocate).round(0).bytes()));
        } finally {
            other.shutdown();
        }
    }

    @Test
    void aRoundHasWholeCycles() {
        List<Integer> played = new ArrayList<>();
        Bodies body = new Bodies(1);
        body.add(0, 0, 1, 1);
        StateTurns turns = new StateTurns(Collections.nCopies(1100, body), (bodies, sink) -> { });
        assertEquals(3, turns.cycle());
        for (int k = 0; k < 4; k++) {
            turns.prepare();
            played.add((int) turns.run());
        }
        assertEquals(List.of(512, 512, 76, 512), played);
    }

    @Test
    void statesArriveAsTheyWere() throws IOException {
        Bodies bodies = new Bodies(5, 2);
        for (int k = 0; k < 4; k++) {
            bodies.add(k, 2 * k, 1 + k, k == 2 ? Double.POSITIVE_INFINITY : 1.5);
        }
        bodies.remove(1);
        bodies.takeId();
        bodies.addPoint(7, 8, 2);
        bodies.setVelocity(0, -0.0, 1e-300);
        bodies.setRestitution(1, 0.25);
        bodies.setDrag(1, 0.5);
        bodies.setKind(3, 4);
        bodies.columns[1][3] = Math.PI;
        bodies.passing().add(2, 5);
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        StateBytes.write(new DataOutputStream(bytes), List.of(bodies));
        Bodies read = StateBytes.read(new DataInputStream(new ByteArrayInputStream(bytes.toByteArray()))).get(0);
        assertEquals(bodies.size(), read.size());
        assertEquals(bodies.capacity(), read.capacity());
        assertEquals(bodies.nextId(), read.nextId());
        for (double[][] both : new double[][][] {{bodies.x, read.x}, {bodies.y, read.y}, {bodies.vx, read.vx},
            {bodies.vy, read.vy}, {bodies.radius, read.radius}, {bodies.mass, read.mass},
            {bodies.inverseMass, read.inverseMass}, {bodies.restitution, read.restitution}, {bodies.drag, read.drag},
            {bodies.columns[0], read.columns[0]}, {bodies.columns[1], read.columns[1]}}) {
            assertArrayEquals(Arrays.copyOf(both[0], bodies.size()), Arrays.copyOf(both[1], bodies.size()));
        }
        for (int k = 0; k < bodies.size(); k++) {
            assertEquals(bodies.id(k), read.id(k));
            assertEquals(bodies.kind[k], read.kind[k]);
        }
        assertTrue(read.passing().contains(2, 5));
    }

    /** The program of the other JVM. */
    public static void main(String[] arguments) throws IOException {
        TimingChild.serve(System.in, System.out, job -> {
            if (job.scene().isEmpty()) {
                throw new IllegalArgumentException("no such job");
            }
            return () -> {
                long end = WorkClock.THREAD.nanos() + NANOS_PER_MS;
                while (WorkClock.THREAD.nanos() < end) {
                    Thread.onSpinWait();
                }
                return 10;
            };
        });
    }

    private static RungJob job(String scene) {
        return new RungJob(scene, Accuracy.ladder().get(0), 1, List.of());
    }

    @Test
    @Tag("process")
    void anotherJvmTimesItsJob() {
        TimingJvm jvm = new TimingJvm(TimingTest.class, job("a scene"));
        try (jvm) {
            jvm.warmUp(0, 0.01);
            for (int round = 0; round < 2; round++) {
                assertTrue(jvm.round(0.01).nanos() >= 100_000, "ten turns of a millisecond");
            }
            assertTrue(jvm.isAlive());
        }
        assertFalse(jvm.isAlive());
    }

    @Test
    @Tag("process")
    void aJvmThatFailsSaysWhy() {
        assertEquals("the JVM for timing has failed: java.lang.IllegalArgumentException: no such job",
            assertThrows(IllegalStateException.class, () -> new TimingJvm(TimingTest.class, job(""))).getMessage());
        String other = assertThrows(IllegalStateException.class,
            () -> new TimingJvm(String.class, job("a scene"))).getMessage();
        assertTrue(other.startsWith("the JVM for timing has failed: ") && other.contains("java.lang.String"), other);
    }
}
