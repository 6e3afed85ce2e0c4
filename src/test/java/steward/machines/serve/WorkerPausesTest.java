package steward.machines.serve;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;

class WorkerPausesTest {

    private long seconds;
    private final WorkerPauses pauses = new WorkerPauses(() -> TimeUnit.SECONDS.toNanos(seconds));

    @Test
    void pausesDoubleUntilATestIsPassed() {
        assertTrue(pauses.mayTake("a"));
        assertTrue(pauses.failed("a"));
        for (int length = 1; length < 600; length = Math.min(600, 2 * length)) {
            assertFalse(pauses.mayTake("a"), "for " + length + " s");
            assertEquals(0, pauses.places("a", 8));
            assertFalse(pauses.failed("a"), "a game that was under way");
            seconds += length;
            assertTrue(pauses.mayTake("a"), "after " + length + " s");
            assertEquals(1, pauses.places("a", 8));
            pauses.took("a");
            assertFalse(pauses.mayTake("a"), "one job is the test");
            assertFalse(pauses.failed("a"), "said once");
        }
        assertTrue(pauses.mayTake("b"), "another worker");
        seconds += 600;
        assertTrue(pauses.played("a"));
        assertFalse(pauses.played("a"));
        assertEquals(8, pauses.places("a", 8));
    }

    @Test
    void aWorkerThatJoinsAnewIsTestedAnew() {
        pauses.failed("a");
        seconds += 1;
        pauses.took("a");
        assertFalse(pauses.mayTake("a"));
        pauses.joined("a");
        assertTrue(pauses.mayTake("a"));
    }
}
