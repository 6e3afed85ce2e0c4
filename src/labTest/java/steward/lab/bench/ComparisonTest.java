package steward.lab.bench;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import steward.lab.timing.Stretch;
import steward.lab.timing.TimingEffort;
import steward.lab.timing.WorkTimer;

/** Rows of contenders, also when the run is interrupted. */
class ComparisonTest {

    private static final TimingEffort BRIEF = new TimingEffort(1, 5, 0.001, 0, 0);

    private final List<Row> rows = new ArrayList<>();
    private final AtomicInteger steps = new AtomicInteger();

    /** The thread is interrupted at the so-manieth step: two warm-ups, and then the rounds. */
    private void compare(TimingEffort effort, int interruptedAt, Contender... contenders) throws Exception {
        Thread measuring = Thread.currentThread();
        new Comparison("section", "units", List.of(contenders), Comparison::paired).run(effort, () -> {
            if (steps.incrementAndGet() == interruptedAt) {
                measuring.interrupt();
            }
        }, rows::add);
    }

    private static Contender idle(String name) {
        return new Contender(name, new WorkTimer(() -> 1));
    }

    /** Contender whose rounds take so many nanoseconds, the warm-up the first of them. */
    private static Contender taking(String name, double... nanos) {
        int[] next = new int[1];
        return new Contender(name, least -> new Stretch(nanos[next[0]++ % nanos.length], 7));
    }

    /** The median of 200, 220, 240, 260 and 280 is 2.4 times that of 100, and 140 ns more. */
    @Test
    void everyContenderHasARow() throws Exception {
        compare(new TimingEffort(1, 5, 0, 0, 0), 0, taking("a", 100), taking("b", 280, 240, 200, 220, 260));

        assertEquals(7, steps.get());
        assertEquals(List.of(new Row("section", "a", "units", 1e7, 1, 7, ""), new Row("section", "b", "units",
            1e9 / 240, 100.0 / 240, 7, "2.400 times the first (median of pairs), +140 ns")), rows);
    }

    @Test
    void oneAloneHasNoRatio() throws Exception {
        compare(new TimingEffort(1, 1, 0, 0, 0), 0, taking("a", 100));

        assertTrue(Double.isNaN(rows.get(0).ratio()));
        assertEquals("", rows.get(0).note());
    }

    /** Of five rounds the lowest and the highest do not count: of 100 the others take 0.50 to 0.67. */
    @Test
    void aRatioWhoseRoundsDifferIsSaidToBeNotComparable() throws Exception {
        compare(new TimingEffort(1, 5, 0, 0, 0), 0, taking("a", 100), taking("b", 100, 150, 160, 200, 300));

        assertEquals("", rows.get(0).note());
        assertTrue(rows.get(1).note().endsWith(", ratio not comparable: 0.50 to 0.67 in its rounds"),
            rows.get(1).note());
    }

    @Test
    void ratiosOfFewRoundsAreNotComparable() throws Exception {
        compare(new TimingEffort(1, 4, 0, 0, 0), 0, taking("a", 100), taking("b", 200));

        assertEquals("", rows.get(0).note());
        assertTrue(rows.get(1).note().endsWith(", few rounds: ratio not comparable"), rows.get(1).note());
    }

    @Test
    void anInterruptedMeasurementTellsItsWholeRounds() {
        assertThrows(InterruptedException.class, () -> compare(BRIEF, 3, idle("a"), idle("b")));

        assertEquals(List.of("a", "b"), rows.stream().map(Row::name).toList());
        assertTrue(rows.stream().allMatch(row -> row.note().contains("1 of 5 rounds")), rows.toString());
        assertFalse(Thread.interrupted());
    }

    @Test
    void withoutAWholeRoundThereIsNothingToTell() {
        assertThrows(InterruptedException.class, () -> compare(BRIEF, 2, idle("a"), idle("b")));

        assertEquals(List.of(), rows);
    }

    /** Work that meets the interrupt itself says so in its own way, and leaves the thread interrupted. */
    @Test
    void workThatIsBrokenOffByTheInterruptIsNoOtherProblem() {
        Contender writer = new Contender("writer", least -> {
            if (Thread.currentThread().isInterrupted()) {
                throw new IllegalStateException("closed by interrupt");
            }
            return new Stretch(1, 0);
        });
        assertThrows(IllegalStateException.class,
            () -> compare(new TimingEffort(1, 5, 0, 0, 0), 4, writer, writer));
        assertEquals(List.of("2 of 5 rounds", "2 of 5 rounds"), rows.stream().map(row ->
            row.note().replaceFirst(".*, ", "")).toList());
    }
}
