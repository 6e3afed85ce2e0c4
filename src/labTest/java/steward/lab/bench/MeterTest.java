package steward.lab.bench;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.function.LongSupplier;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;

/** Report about contenders, also when the run is interrupted. */
@Isolated("counts the bytes of all threads")
class MeterTest {

    private final List<Row> rows = new ArrayList<>();
    private int told;
    private long clock;

    /** The thread is interrupted when it hears for the so-manieth time what is measured. */
    private void compare(int interruptedAt, Contender... contenders) throws Exception {
        new Meter().compare("section", "units", List.of(contenders), Effort.QUICK, about -> {
            if (++told == interruptedAt) {
                Thread.currentThread().interrupt();
            }
        }, rows::add);
    }

    private static Contender idle(String name) {
        return new Contender(name, () -> 1);
    }

    @Test
    void everyContenderHasALine() throws Exception {
        compare(0, idle("a"), idle("b"));

        assertEquals(List.of("a", "b"), rows.stream().map(Row::name).toList());
        assertEquals(1, rows.get(0).ratio());
        assertEquals(2 * (1 + Effort.QUICK.rounds()), told);
        assertTrue(rows.stream().allMatch(row -> row.perSecond() > 0));
    }

    private static byte[] garbage;

    /** 100,000 bytes a unit, by this thread or by another one that lives on; by the wall clock they are not counted. */
    @Test
    @Tag("slow")
    @Tag("campaign")
    void bytesAreCountedInWhicheverThreadAllocates() throws Exception {
        ExecutorService other = Executors.newSingleThreadExecutor();
        try {
            compare(0, new Contender("here", () -> allocate(100_000)),
                new Contender("elsewhere", true, () -> other.submit(() -> allocate(100_000)).get()),
                new Contender("wall", Contender.Clock.WALL, () -> allocate(100_000)));
        } finally {
            other.shutdown();
        }

        assertEquals(100_000, rows.get(0).bytes(), 5_000);
        assertEquals(100_000, rows.get(1).bytes(), 10_000);
        assertTrue(Double.isNaN(rows.get(2).bytes()));
    }

    private static long allocate(int bytes) {
        garbage = new byte[bytes];
        return 1;
    }

    /** Contender that takes so many nanoseconds for a unit, by the clock of the test. */
    private Contender taking(String name, LongSupplier nanos) {
        return new Contender(name, () -> {
            clock += nanos.getAsLong();
            return 1;
        });
    }

    private void compareByOwnClock(LongSupplier compiled, Contender... contenders) throws Exception {
        new Meter(kind -> clock, compiled).compare("section", "units", List.of(contenders), Effort.QUICK,
            about -> { }, rows::add);
    }

    /** A second and a half at most: the one is ten times as fast from 300 ms of its own on. */
    @Test
    void aContenderThatBecomesFasterIsWarmedUpUntilItHas() throws Exception {
        long[] spent = new long[1];
        compareByOwnClock(() -> 0, taking("steady", () -> 1_000_000), taking("compiled", () -> {
            long nanos = spent[0] < 300_000_000 ? 1_000_000 - spent[0] / 400 : 100_000;
            spent[0] += nanos;
            return nanos;
        }));

        assertEquals(10, rows.get(1).ratio(), 0.01);
        assertEquals("", rows.get(1).note());
    }

    /** As before, but its speed is one and the same until the compiler is done, which takes 300 ms. */
    @Test
    void aContenderThatIsBeingCompiledIsNotSettled() throws Exception {
        long[] spent = new long[1];
        compareByOwnClock(() -> Math.min(300, spent[0] / 1_000_000), taking("steady", () -> 1_000_000),
            taking("compiled", () -> {
                long nanos = spent[0] < 300_000_000 ? 1_000_000 : 100_000;
                spent[0] += nanos;
                return nanos;
            }));

        assertEquals(10, rows.get(1).ratio(), 0.01);
        assertEquals("", rows.get(1).note());
    }

    @Test
    void aRatioWhoseRoundsDifferIsSaidToBeNotComparable() throws Exception {
        long[] units = new long[1];
        compareByOwnClock(() -> 0, taking("steady", () -> 1_000_000),
            taking("restless", () -> 1_000_000 + 1_000_000 * (units[0]++ / 20 % 3)));

        assertEquals("", rows.get(0).note());
        assertTrue(rows.get(1).note().matches("ratio not comparable: 0\\.\\d\\d to \\d\\.\\d\\d in its rounds"),
            rows.get(1).note());
    }

    @Test
    void anInterruptedMeasurementTellsItsCompleteRounds() {
        assertThrows(InterruptedException.class, () -> compare(6, idle("a"), idle("b")));

        assertEquals(List.of("1 of 5 rounds", "1 of 5 rounds"), rows.stream().map(Row::note).toList());
        assertFalse(Thread.interrupted());
    }

    @Test
    void withoutACompleteRoundThereIsNothingToTell() {
        assertThrows(InterruptedException.class, () -> compare(4, idle("a"), idle("b")));

        assertEquals(List.of(), rows);
    }

    /** Work that meets the interrupt itself says so in its own way, and leaves the thread interrupted. */
    @Test
    @Tag("slow")
    void workThatIsBrokenOffByTheInterruptIsNoOtherProblem() {
        Contender writer = new Contender("writer", () -> {
            if (Thread.currentThread().isInterrupted()) {
                throw new IllegalStateException("closed by interrupt");
            }
            return 1;
        });
        assertThrows(IllegalStateException.class, () -> compare(5, idle("a"), writer, writer));
        assertEquals(List.of(), rows, "in the first round");
        told = 0;
        assertThrows(IllegalStateException.class, () -> compare(8, idle("a"), writer, writer));
        assertEquals(3, rows.size());
    }
}
