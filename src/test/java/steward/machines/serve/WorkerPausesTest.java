package steward.machines.serve;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import steward.machines.token.KeptPauses.Pause;

class WorkerPausesTest {

    private long seconds;
    private final Map<String, Pause> kept = new TreeMap<>();
    private final WorkerPauses pauses = pauses();

    private WorkerPauses pauses() {
        return new WorkerPauses(() -> TimeUnit.SECONDS.toMillis(seconds), kept, all -> {
            kept.clear();
            kept.putAll(all);
        });
    }

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

    /** The broker asks whether a worker may take a job some time before it hands it over. */
    @Test
    void aJobThatWasOnItsWayWhenThePauseBeganIsNoTest() {
        assertTrue(pauses.mayTake("a"));
        pauses.failed("a");
        pauses.took("a");
        assertFalse(pauses.failed("a"), "that job");
        seconds += 1;
        assertTrue(pauses.mayTake("a"), "its test");
    }

    @Test
    void aWorkerThatJoinsAnewIsTestedAnew() {
        pauses.failed("a");
        seconds += 1;
        pauses.took("a");
        assertFalse(pauses.mayTake("a"));
        pauses.untested("a");
        assertTrue(pauses.mayTake("a"));
    }

    @Test
    void theNextRunGoesOnWithThem() {
        pauses.failed("a");
        seconds += 1;
        pauses.failed("a");
        WorkerPauses next = pauses();
        assertFalse(next.mayTake("a"), "for 2 s");
        seconds += 2;
        assertTrue(next.mayTake("a"), "its test");
        next.took("a");
        assertFalse(next.failed("a"));
        assertEquals(4000, kept.get("a").length());
        seconds += 4;
        assertTrue(next.played("a"));
        assertEquals(Map.of(), kept);
    }

    @Test
    void aClockThatIsSetBackEndsAPause() {
        seconds = 1000;
        pauses.failed("a");
        seconds = 0;
        assertTrue(pauses.mayTake("a"));
    }
}
