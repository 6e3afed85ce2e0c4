package steward.bot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** The words of faults. */
class FaultsTest {

    private static final long MS = 1_000_000;

    @Test
    void waitsAreRoundedUpSoThatTheyNeverReadLikeTheLimit() {
        assertEquals("0.1 ms", Faults.waited(1));
        assertEquals("5.1 ms", Faults.waited(5 * MS + 1));
        assertEquals("5.0 ms", Faults.waited(5 * MS));
        assertEquals("9.9 ms", Faults.waited(9_900_000));
        assertEquals("10 ms", Faults.waited(9_900_001));
        assertEquals("76 ms", Faults.waited(75 * MS + 1));
    }

    @Test
    void limitsAreWrittenAsTheyWereSet() {
        assertEquals("75 ms", Faults.limit(75 * MS));
        assertEquals("112.5 ms", Faults.limit(112_500_000));
        assertEquals("0.05 ms", Faults.limit(50_000));
        assertEquals("1000 ms", Faults.limit(1000 * MS));
    }

    @Test
    void aLateAnswerSaysWhatHadCome() {
        assertEquals("no answer within 75 ms (waited 76 ms)", Faults.late(75 * MS, 76 * MS));
        assertEquals("no answer within 75 ms (waited 76 ms)", Faults.late(75 * MS, 76 * MS, 0, 2, 0));
        assertEquals("no answer within 75 ms (waited 76 ms)", Faults.late(75 * MS, 76 * MS, 2, 2, 9));
        assertEquals("no answer within 75 ms (waited 76 ms): 1 of 2 lines came",
            Faults.late(75 * MS, 76 * MS, 1, 2, 0));
        assertEquals("no answer within 75 ms (waited 76 ms): 3 bytes came, without a line end",
            Faults.late(75 * MS, 76 * MS, 0, 1, 3));
        assertEquals("did not read its input within 75 ms (waited 76 ms)", Faults.deaf(75 * MS, 76 * MS));
    }

    @Test
    void exitStatusesAndSignalsHaveTheirNames() {
        assertEquals("exited with status 0 before answering", Faults.exited(0));
        assertEquals("exited with status 3 before answering", Faults.exited(3));
        assertEquals("exited with status 128 before answering", Faults.exited(128));
        assertEquals("exited with status 255 before answering", Faults.exited(255));
        assertEquals("killed by signal 11 (SIGSEGV) before answering", Faults.exited(139));
        assertEquals("killed by signal 9 (SIGKILL) before answering", Faults.exited(137));
        assertEquals("killed by signal 31 (SIGSYS) before answering", Faults.exited(159));
        assertEquals("killed by signal 40 before answering", Faults.exited(168));
        assertEquals("exited with status 127 before answering (127: a command was not found)", Faults.exited(127));
        assertEquals("exited with status 126 before answering (126: a command cannot be executed)",
            Faults.exited(126));
    }

    @Test
    void theKindOfAFaultCanBeAskedFor() {
        assertTrue(Faults.isLate(Faults.late(75 * MS, 76 * MS)));
        assertTrue(Faults.isExit(Faults.exited(3)) && Faults.isExit(Faults.exited(139)));
        assertTrue(Faults.isExit(Faults.exited(127), 127));
        assertFalse(Faults.isExit(Faults.exited(12), 127) || Faults.isExit(Faults.late(1, 2)));
        assertFalse(Faults.isLate(Faults.deaf(1, 2)));
    }
}
