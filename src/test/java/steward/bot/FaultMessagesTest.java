package steward.bot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import steward.bot.TimeSpent.Shows;

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
        String late = FaultMessages.late(75 * MS, 76 * MS);
        assertEquals("no answer within 75 ms (waited 76 ms)", late);
        assertEquals(late, FaultMessages.withLines(late, 0, 2, 0));
        assertEquals(late, FaultMessages.withLines(late, 2, 2, 9));
        assertEquals(late + ": 1 of 2 lines came", FaultMessages.withLines(late, 1, 2, 0));
        assertEquals(late + ": 3 bytes came, without a line end", FaultMessages.withLines(late, 0, 1, 3));
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
    }

    /** 19 + 2 + 53 + 2 = 76: the parts of one deadline add up to what was waited. */
    @Test
    void aMissedDeadlineTellsWhereTheTimeWent() {
        TimeSpent spent = new TimeSpent(75 * MS, 76 * MS, 19 * MS, 2 * MS, 53 * MS, 2 * MS, 2 * MS, Shows.ALL, false);
        String parts = "the machine was busy: not its fault [computed 2, waited 53 for a processor, 2 other, 19 before "
            + "the first look]";
        assertEquals("no answer within 75 ms (waited 76 ms): " + parts,
            FaultMessages.missed(spent, TimeBasis.WALL, false, 0, 1, 0));
        assertEquals("no answer within 75 ms (waited 76 ms): 1 of 2 lines came; " + parts,
            FaultMessages.missed(spent, TimeBasis.WALL, false, 1, 2, 0));
        assertEquals("did not read its input within 75 ms (waited 76 ms): " + parts,
            FaultMessages.missed(spent, TimeBasis.WALL, true, 0, 1, 0));
    }

    @Test
    void aLimitOfCpuTimeIsToldFromItsBackstop() {
        TimeSpent used = new TimeSpent(75 * MS, 133 * MS, 0, 81 * MS, 40 * MS, 12 * MS, 81 * MS, Shows.ALL, true);
        assertEquals("no answer within 75 ms of CPU time (used 81 ms in 133 ms): computed all the time: an "
            + "endless loop, or too slow? [computed 81, waited 40 for a processor, 12 other]",
            FaultMessages.missed(used, TimeBasis.CPU, false, 0, 1, 0));
        TimeSpent slept = new TimeSpent(750 * MS, 751 * MS, 0, 0, 0, 751 * MS, 0, Shows.ALL, false);
        assertEquals("no answer within 750 ms, 10 times the limit of CPU time (waited 751 ms): computed for 0 ms, "
            + "then waited, as for input that nobody had sent: does it read too much, or not flush? [computed 0, "
            + "waited 0 for a processor, 751 other]", FaultMessages.missed(slept, TimeBasis.CPU, false, 0, 1, 0));
        assertTrue(FaultMessages.isLate(FaultMessages.missed(used, TimeBasis.CPU, false, 0, 1, 0)));
    }

    @Test
    void whatTheKernelDoesNotShowIsSaid() {
        assertEquals("computed 20 (in steps of 10 ms), 56 other (this system does not show waiting for a processor)",
            new TimeSpent(75 * MS, 76 * MS, 0, 20 * MS, 0, 56 * MS, 20 * MS, Shows.STEPS, false).text());
        assertEquals("the machine was busy: perhaps not its fault [computed 20 (in steps of 10 ms), waited 30 for a "
            + "processor, 26 other]",
            new TimeSpent(75 * MS, 76 * MS, 0, 20 * MS, 30 * MS, 26 * MS, 20 * MS, Shows.ALL_IN_STEPS, false).text());
        assertEquals("this system does not show what the bot did meanwhile",
            TimeSpent.unknown(75 * MS, 76 * MS).text());
    }

    /** Half of 75 ms is 37.5 ms. */
    @Test
    void aMachineIsStarvedWhenTheBotWaitedHalfOfItsLimit() {
        assertTrue(waiting(37_500_000, false).starved());
        assertFalse(waiting(37_400_000, false).starved());
        assertFalse(waiting(60 * MS, true).starved());
        assertFalse(TimeSpent.unknown(75 * MS, 76 * MS).starved());
    }

    /** Limit 75 ms, first look after 19. A bot that never had the processor afterwards did not have it before. */
    @Test
    void timeBeforeTheFirstLookIsWaitingUnlessTheBotHadTheProcessor() {
        assertTrue(new TimeSpent(75 * MS, 76 * MS, 19 * MS, 0, 19 * MS, 38 * MS, 0, Shows.ALL, false).starved());
        assertFalse(new TimeSpent(75 * MS, 76 * MS, 19 * MS, 38 * MS, 19 * MS, 0, 38 * MS, Shows.ALL, false).starved());
        assertFalse(new TimeSpent(75 * MS, 76 * MS, 19 * MS, 0, 18 * MS, 39 * MS, 0, Shows.ALL, false).starved());
    }

    private static TimeSpent waiting(long waited, boolean overCpu) {
        return new TimeSpent(75 * MS, 76 * MS, 0, 0, waited, 76 * MS - waited, 0, Shows.ALL, overCpu);
    }
}
