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
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import steward.physics.Bodies;

/** Rounds that go from place to place, what is said of them, and a JVM that times for this one. */
class TimingTest {

    private static final TimingEffort EFFORT = new TimingEffort(2, 3, 0.5, 0.25, 4);

    /** A place that tells what it is asked to do, and takes as many nanoseconds as its list says, round by round. */
    private record Told(String name, Consumer<String> told, AtomicInteger rounds, double... nanos)
        implements TimedPlace {

        @Override
        public boolean warmUp(double least, double most) {
            told.accept(name + " warm " + least + " " + most);
            return nanos[0] < 100;
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

    @Test
    void roundsGoFromPlaceToPlaceAndBack() {
        List<String> told = Collections.synchronizedList(new ArrayList<>());
        Map<String, AtomicInteger> rounds = new ConcurrentHashMap<>();
        Timing timing = new Timing(EFFORT, job -> {
            String name = new String(job);
            return new Told(name, told::add, rounds.computeIfAbsent(name, any -> new AtomicInteger()),
                name.equals("a") ? new double[] {10, 30, 20, 12, 11, 13} : new double[] {200, 240, 220, 210, 260, 230});
        });
        AtomicInteger steps = new AtomicInteger();
        TimingSamples samples = timing.run(List.of("a".getBytes(), "b".getBytes()), steps::incrementAndGet);
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
        assertArrayEquals(new double[] {20, 12}, samples.medians(0), "of each repeat");
        assertEquals(6, samples.bytes(0));
        assertEquals(6, samples.rounds());
    }

    @Test
    void placesAreClosedWhenOneFails() {
        List<String> told = Collections.synchronizedList(new ArrayList<>());
        Timing timing = new Timing(EFFORT, job -> {
            if (job[0] == 'b') {
                throw new IllegalStateException("no b");
            }
            return new Told("a", told::add, new AtomicInteger(), 1, 2, 3);
        });
        assertEquals("no b", assertThrows(IllegalStateException.class,
            () -> timing.run(List.of("a".getBytes(), "b".getBytes()), () -> { })).getMessage());
        assertEquals(told.stream().anyMatch(line -> line.contains("warm")) ? 1 : 0,
            told.stream().filter(line -> line.equals("a closed")).count(), told.toString());
    }

    /** Turns whose cost falls until the twelfth, as when code is compiled late: 5 alike follow 5 alike at 20. */
    @Test
    void warmingUpGoesOnUntilTimesAreSteady() {
        AtomicInteger runs = new AtomicInteger();
        TimedTurns late = new TimedTurns() {
            @Override
            public void run() {
                spin(Math.max(400_000, 4_000_000 - 300_000L * runs.incrementAndGet()));
            }

            @Override
            public int turns() {
                return 1;
            }
        };
        new TurnTimer(late).warmUp(0, 60);
        assertTrue(runs.get() >= 20, "stretches: " + runs);
        runs.set(0);
        assertFalse(new TurnTimer(late).warmUp(0, 0), "no time to become steady");
    }

    private static void spin(long nanos) {
        WorkClock clock = new WorkClock();
        long end = clock.nanos() + nanos;
        while (clock.nanos() < end) {
            Thread.onSpinWait();
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
            turns.run();
            played.add(turns.turns());
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
            if (job.readInt() == 0) {
                throw new IllegalArgumentException("no such job");
            }
            return new TimedTurns() {
                @Override
                public void run() {
                    spin(1_000_000);
                }

                @Override
                public int turns() {
                    return 10;
                }
            };
        });
    }

    private static byte[] job(int number) {
        return new byte[] {0, 0, 0, (byte) number};
    }

    @Test
    @Tag("process")
    void anotherJvmTimesItsJob() {
        TimingJvm jvm = new TimingJvm(TimingTest.class, job(1));
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
            assertThrows(IllegalStateException.class, () -> new TimingJvm(TimingTest.class, job(0))).getMessage());
        String other = assertThrows(IllegalStateException.class,
            () -> new TimingJvm(String.class, job(1))).getMessage();
        assertTrue(other.startsWith("the JVM for timing has failed: ") && other.contains("java.lang.String"), other);
    }
}
