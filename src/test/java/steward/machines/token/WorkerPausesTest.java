package steward.machines.token;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import steward.files.InputException;
import steward.league.LeagueFolder;

class WorkerPausesTest {

    @TempDir
    private Path folder;
    private long seconds;
    private WorkerPauses pauses;

    @BeforeEach
    void begin() {
        pauses = pauses();
    }

    private WorkerPauses pauses() {
        return new WorkerPauses(() -> TimeUnit.SECONDS.toMillis(seconds), new LeagueFolder(folder));
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
        seconds += 3;
        assertFalse(pauses().mayTake("a"), "for 4 s");
        seconds += 1;
        assertTrue(next.played("a"));
        assertEquals(8, pauses().places("a", 8));
    }

    @Test
    void aClockThatIsSetBackEndsAPause() {
        seconds = 1000;
        pauses.failed("a");
        seconds = 0;
        assertTrue(pauses.mayTake("a"));
    }

    @Test
    void aDamagedFileIsNamed() throws IOException {
        pauses.failed("a");
        Path file = folder.resolve("machines/pauses.json");
        Files.writeString(file, Files.readString(file).replaceAll("\\d{4}-\\d\\d", "1970-21"));
        String said = assertThrows(InputException.class, this::pauses).getMessage();
        assertTrue(said.startsWith(file + ":2:"), said);
    }
}
