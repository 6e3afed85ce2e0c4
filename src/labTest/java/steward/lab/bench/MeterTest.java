package steward.lab.bench;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Report about contenders, also when the run is interrupted. */
class MeterTest {

    private final List<Row> rows = new ArrayList<>();
    private int told;

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
        assertTrue(rows.stream().allMatch(row -> row.note().isEmpty() && row.perSecond() > 0));
    }

    @Test
    void anInterruptedMeasurementTellsItsCompleteRounds() {
        assertThrows(InterruptedException.class, () -> compare(6, idle("a"), idle("b")));

        assertEquals(List.of("1 of 3 rounds", "1 of 3 rounds"), rows.stream().map(Row::note).toList());
        assertFalse(Thread.interrupted());
    }

    @Test
    void withoutACompleteRoundThereIsNothingToTell() {
        assertThrows(InterruptedException.class, () -> compare(4, idle("a"), idle("b")));

        assertEquals(List.of(), rows);
    }

    /** Work that meets the interrupt itself says so in its own way, and leaves the thread interrupted. */
    @Test
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
