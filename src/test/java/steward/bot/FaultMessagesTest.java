package steward.bot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** The words of faults. */
class FaultMessagesTest {

    private static final long MS = 1_000_000;

    @Test
    void waitsAreRoundedUpSoThatTheyNeverReadLikeTheLimit() {
        assertEquals("0.1 ms", FaultMessages.waited(1));
        assertEquals("5.1 ms", FaultMessages.waited(5 * MS + 1));
        assertEquals("5.0 ms", FaultMessages.waited(5 * MS));
        assertEquals("9.9 ms", FaultMessages.waited(9_900_000));
        assertEquals("10 ms", FaultMessages.waited(9_900_001));
        assertEquals("76 ms", FaultMessages.waited(75 * MS + 1));
    }

    @Test
    void limitsAreWrittenAsTheyWereSet() {
        assertEquals("75 ms", FaultMessages.limit(75 * MS));
        assertEquals("112.5 ms", FaultMessages.limit(112_500_000));
        assertEquals("0.05 ms", FaultMessages.limit(50_000));
        assertEquals("1000 ms", FaultMessages.limit(1000 * MS));
    }

    @Test
    void aLateAnswerSaysWhatHadCome() {
        assertEquals("no answer within 75 ms (waited 76 ms)", FaultMessages.late(75 * MS, 76 * MS));
        assertEquals("no answer within 75 ms (waited 76 ms)", FaultMessages.late(75 * MS, 76 * MS, 0, 2, 0));
        assertEquals("no answer within 75 ms (waited 76 ms)", FaultMessages.late(75 * MS, 76 * MS, 2, 2, 9));
        assertEquals("no answer within 75 ms (waited 76 ms): 1 of 2 lines came",
            FaultMessages.late(75 * MS, 76 * MS, 1, 2, 0));
        assertEquals("no answer within 75 ms (waited 76 ms): 3 bytes came, without a line end",
            FaultMessages.late(75 * MS, 76 * MS, 0, 1, 3));
        assertEquals("did not read its input within 75 ms (waited 76 ms)", FaultMessages.inputUnread(75 * MS, 76 * MS));
    }

    @Test
    void exitStatusesAndSignalsHaveTheirNames() {
        assertEquals("exited with status 0 before answering", FaultMessages.exited(0));
        assertEquals("exited with status 3 before answering", FaultMessages.exited(3));
        assertEquals("exited with status 128 before answering", FaultMessages.exited(128));
        assertEquals("exited with status 255 before answering", FaultMessages.exited(255));
        assertEquals("killed by signal 11 (SIGSEGV) before answering", FaultMessages.exited(139));
        assertEquals("killed by signal 9 (SIGKILL) before answering", FaultMessages.exited(137));
        assertEquals("killed by signal 31 (SIGSYS) before answering", FaultMessages.exited(159));
        assertEquals("killed by signal 40 before answering", FaultMessages.exited(168));
        assertEquals("exited with status 127 before answering (127: a command was not found)",
            FaultMessages.exited(127));
        assertEquals("exited with status 126 before answering (126: a command cannot be executed)",
            FaultMessages.exited(126));
    }

    @Test
    void theKindOfAFaultCanBeAskedFor() {
        assertTrue(FaultMessages.isLate(FaultMessages.late(75 * MS, 76 * MS)));
        assertTrue(FaultMessages.isExit(FaultMessages.exited(3)) && FaultMessages.isExit(FaultMessages.exited(139)));
        assertTrue(FaultMessages.isExit(FaultMessages.exited(127), 127));
        assertFalse(FaultMessages.isExit(FaultMessages.exited(12), 127)
            || FaultMessages.isExit(FaultMessages.late(1, 2)));
        assertFalse(FaultMessages.isLate(FaultMessages.inputUnread(1, 2)));
    }
}
