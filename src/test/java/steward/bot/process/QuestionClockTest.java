package steward.bot.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Map;
import org.junit.jupiter.api.Test;
import steward.bot.FaultMessages;
import steward.bot.TimeBasis;
import steward.bot.TimeSpent;
import steward.bot.accounting.OwnThread;
import steward.bot.accounting.TreeSample;
import steward.bot.accounting.TreeSample.ThreadTimes;
import steward.bot.accounting.TreeSampler;

/**
 * When a question's time is up. The clock, the asking thread and the bot's processes are numbers that a test sets: a
 * limit of 80 ms, of which a quarter is 20 and an eighth 10.
 */
class QuestionClockTest {

    private static final long MS = 1_000_000;
    private static final long LIMIT = 80 * MS;
    private static final long START = 1000 * MS;

    private OwnThread.State asking = OwnThread.State.ASLEEP;
    private long cpu;
    private long waited;
    private int samples;
    private Runnable whileSampling = () -> { };

    private final QuestionClock clock = new QuestionClock(() -> asking, this::sample);

    /** One thread, which has run and waited for a processor for so long, and does nothing else. */
    private TreeSample sample(long at) {
        samples++;
        whileSampling.run();
        return new TreeSample(at, true, 1, 0, Map.of(1L, new ThreadTimes(cpu, waited, 1, false)), 0);
    }

    private void ask(long limit) {
        clock.begin(limit, START, clock.needsBaseline() ? sample(START) : null);
        clock.frameWritten(START);
    }

    /** A look so many milliseconds after the frame; gives the next one, counted likewise, or -1 for the end. */
    private double look(double ms, double overslept) {
        long next = clock.look(START + Math.round(ms * MS), Math.round(overslept * MS));
        return next == QuestionClock.PASSED ? -1 : (next - START) / (double) MS;
    }

    @Test
    void itIsLookedAtAfterAQuarterThenEveryEighth() {
        ask(LIMIT);
        assertEquals(START + 20 * MS, clock.firstLook());
        assertEquals(20, look(5, 0));
        assertEquals(0, samples, "a look before a quarter of the limit costs something");
        assertEquals(30, look(20, 0));
        assertEquals(1, samples);
        assertEquals(40, look(30, 0));
        assertEquals(79.9, look(69.9, 0));
        assertEquals(1, samples, "a search that uses most of its time pays for one look");
        assertEquals(80, look(70, 0));
        assertEquals(2, samples, "seven eighths");
        assertEquals(80, look(75, 0));
        assertEquals(2, samples);
    }

    /** It may be between two reads: it is late only if it sleeps at two looks, 0.2 ms apart. */
    @Test
    void theTimeIsUpWhenTheAskingThreadSleepsInItsRead() {
        ask(LIMIT);
        assertEquals(80.2, look(80, 0));
        assertEquals(-1, look(80.2, 0));
        assertFalse(clock.unread());
        assertEquals(80_200_000, clock.taken());
    }

    /** Something has come, and waits for the referee: first the referee reads it. */
    @Test
    void anAnswerThatLiesInThePipeIsLookedAtBeforeTheVerdict() {
        ask(LIMIT);
        asking = OwnThread.State.AWAKE;
        assertEquals(81, look(80, 0));
        assertEquals(90, look(89, 0));
        assertEquals(LIMIT, clock.charge(START + 89 * MS), "it is charged what the bot had");
        asking = OwnThread.State.ASLEEP;
        assertEquals(90.2, look(90, 0));
        assertEquals(-1, look(90.2, 0));
    }

    /** A bot that sends byte for byte keeps the thread awake: in all for two seconds at most. */
    @Test
    void nobodyHoldsTheVerdictUpForEver() {
        ask(LIMIT);
        asking = OwnThread.State.AWAKE;
        int looks = 0;
        for (double at = 80; at >= 0; at = look(at, 0)) {
            looks++;
        }
        assertTrue(looks > 1000 && looks < 3000, looks + " looks");
    }

    /** Where the system does not show threads, it is late as if the thread slept. */
    @Test
    void withoutAViewOfThreadsTheTimeIsUpNearlyAtOnce() {
        ask(LIMIT);
        asking = OwnThread.State.UNKNOWN;
        assertEquals(80.2, look(80, 0));
        assertEquals(-1, look(80.2, 0));
    }

    /** Stopped from 20.5 to 520 ms, noticed by the look that was to be at 30: 490 ms are not charged. */
    @Test
    void timeInWhichTheRefereeDidNotRunIsNotCharged() {
        ask(LIMIT);
        assertEquals(30, look(20, 0));
        assertEquals(530, look(520, 490));
        assertEquals(30 * MS, clock.taken());
        assertEquals(570, look(565, 0), "80 + 490");
        assertEquals(570.2, look(570, 0));
        assertEquals(-1, look(570.2, 0));
    }

    /** The watchdog slept long before the question: only what lies after its start is not charged. */
    @Test
    void aPauseBeforeTheQuestionIsNoneOfIts() {
        ask(LIMIT);
        assertEquals(25, look(5, 400));
        assertEquals(0, clock.taken());
    }

    @Test
    void aWakeUpThatIsAMillisecondLateIsUsual() {
        ask(LIMIT);
        look(20.9, 0.9);
        assertEquals(20_900_000, clock.taken());
    }

    @Test
    void theNextQuestionStartsAnew() {
        ask(LIMIT);
        look(520, 490);
        clock.begin(LIMIT, START + 600 * MS, null);
        clock.frameWritten(START + 600 * MS);
        assertEquals(620, look(601, 0));
        assertEquals(MS, clock.taken());
    }

    /** The clock starts when the frame is written; what was not charged before that has nothing to do with it. */
    @Test
    void writingTheFrameStartsTheClock() {
        clock.begin(LIMIT, START, null);
        look(50, 30);
        clock.frameWritten(START + 60 * MS);
        assertEquals(80, look(65, 0), "60 + 20");
        assertEquals(5 * MS, clock.taken());
    }

    /** The referee needed 70 ms to start the program and to write: that is not the program's time. */
    @Test
    void theFirstClockStartsWithTheFrameAsWell() {
        clock.begin(LIMIT, START, TreeSample.beforeStart(START, 0));
        clock.frameWritten(START + 70 * MS);
        assertEquals(150, look(145, 0), "70 + 80");
        assertEquals(150.2, look(150, 0));
        assertEquals(-1, look(150.2, 0));
        assertEquals(80_200_000, clock.taken());
        assertEquals(0, clock.spent(START + 151 * MS, clock.taken()).unobserved(), "all is known from the start");
    }

    /** The thread sleeps while it writes: the pipe is full. */
    @Test
    void aFrameThatCannotBeWrittenIsUnread() {
        clock.begin(LIMIT, START, null);
        asking = OwnThread.State.AWAKE;
        assertEquals(81, look(80, 0), "the referee waits for a processor to write with");
        asking = OwnThread.State.ASLEEP;
        assertEquals(81.2, look(81, 0));
        assertEquals(-1, look(81.2, 0));
        assertTrue(clock.unread());
    }

    @Test
    void withoutALimitItIsNeverUp() {
        ask(Long.MAX_VALUE);
        assertTrue(look(1e9, 0) > 1e9);
        assertEquals(0, samples);
    }

    /** 20 ms before the first look, then 50 of computing; the rest sleeps. */
    @Test
    void itIsToldWhereTheTimeWent() {
        ask(LIMIT);
        cpu = 7 * MS;
        look(20, 0);
        cpu = 57 * MS;
        TimeSpent spent = clock.spent(START + 81 * MS, 81 * MS);
        assertEquals(new TimeSpent(LIMIT, 81 * MS, 20 * MS, 50 * MS, 0, 11 * MS, 50 * MS, TimeSpent.Shows.ALL, false),
            spent);
        cpu = 99 * MS;
        assertEquals(spent, clock.spent(START + 90 * MS, 90 * MS), "looked at again after the verdict");
    }

    /** 81 ms of CPU time in 200 by the clock; what was used before the question does not count. */
    @Test
    void aLimitOfCpuTimeIsExceededByComputing() {
        clock.limitBy(TimeBasis.CPU);
        cpu = 500 * MS;
        ask(LIMIT);
        cpu = 580 * MS;
        assertEquals(200, look(190, 0));
        cpu = 581 * MS;
        assertEquals(-1, look(200, 0));
        TimeSpent spent = clock.spent(START + 200 * MS, 200 * MS);
        assertTrue(spent.overCpu());
        assertEquals(81 * MS, spent.cpu());
        assertEquals(LIMIT, spent.limit());
    }

    /** The time told is the time that has passed, in which the CPU time was used; the referee's pause is part of it. */
    @Test
    void aPauseDoesNotShortenTheTimeInWhichCpuTimeWasUsed() {
        clock.limitBy(TimeBasis.CPU);
        cpu = 0;
        ask(LIMIT);
        cpu = 90 * MS;
        assertEquals(-1, look(130, 110));
        assertEquals(130 * MS, clock.taken());
    }

    /** 60 ms are left at 30 ms; the processors together need so long for them, and an eighth at least. */
    @Test
    void cpuTimeIsLookedAtWhenItMayBeUsedUp() {
        clock.limitBy(TimeBasis.CPU);
        ask(LIMIT);
        cpu = 20 * MS;
        look(30, 0);
        int before = samples;
        double next = 30 + Math.max(10, 60.0 / TreeSampler.processors());
        look(next - 0.1, 0);
        assertEquals(before, samples);
        look(next, 0);
        assertEquals(before + 1, samples);
    }

    @Test
    void byTheClockItMayTakeTenTimesAsLong() {
        clock.limitBy(TimeBasis.CPU);
        ask(LIMIT);
        assertEquals(START + 20 * MS, clock.firstLook());
        assertEquals(800, look(795, 0));
        assertEquals(800.2, look(800, 0));
        assertEquals(-1, look(800.2, 0));
        TimeSpent spent = clock.spent(START + 801 * MS, 801 * MS);
        assertFalse(spent.overCpu());
        assertEquals(10 * LIMIT, spent.limit());
    }

    /** It has computed for 60 of its 80 ms when the clock says 200; then for 82, and is late on any machine. */
    @Test
    void waitingForAProcessorIsNotChargedWhereTheMachineIsNotTo() {
        clock.limitBy(TimeBasis.UNSTARVED);
        ask(LIMIT);
        cpu = 5 * MS;
        waited = 15 * MS;
        assertEquals(30, look(20, 0));
        cpu = 60 * MS;
        waited = 140 * MS;
        assertEquals(210, look(200, 0));
        assertEquals(60 * MS, clock.charge(START + 200 * MS), "what an answer would be charged");
        cpu = 82 * MS;
        waited = 168 * MS;
        assertEquals(250.2, look(250, 0));
        assertEquals(-1, look(250.2, 0));
        TimeSpent spent = clock.spent(START + 251 * MS, clock.taken());
        assertFalse(spent.doubtful());
        assertEquals(0, spent.waited());
        assertEquals(82, spent.computed() / MS);
        String fault = FaultMessages.missed(spent, clock.basis(), false, 0, 1, 0);
        assertTrue(fault.startsWith("no answer within 80 ms, without waiting for a processor (waited 83 ms): computed "
            + "all the time: an endless loop, or too slow? [computed 82, waited 0 for a processor, "), fault);
    }

    /** Sleeping is charged: it would be late on any machine. */
    @Test
    void aBotThatSleepsIsLateWhereTheMachineIsNotChargedToo() {
        clock.limitBy(TimeBasis.UNSTARVED);
        ask(LIMIT);
        waited = 5 * MS;
        assertEquals(85, look(75, 0));
        assertEquals(85.2, look(85, 0));
        assertEquals(-1, look(85.2, 0));
    }

    /** The machine never lets it run: ten times the limit are enough, and it is not the bot's fault. */
    @Test
    void notBeingLetRunAtAllEndsAfterTenTimesTheLimit() {
        clock.limitBy(TimeBasis.UNSTARVED);
        ask(LIMIT);
        waited = 790 * MS;
        assertEquals(809, look(799, 0));
        assertEquals(800.2, look(800, 0));
        assertEquals(-1, look(800.2, 0));
        TimeSpent spent = clock.spent(START + 801 * MS, clock.taken());
        assertTrue(spent.starved());
        String fault = FaultMessages.missed(spent, clock.basis(), false, 0, 1, 0);
        assertTrue(fault.startsWith("no answer within 800 ms (waited 801 ms): the machine was busy: not its fault"),
            fault);
    }

    /** An answer that came before the watchdog looked: it may have used as much as all processors together can. */
    @Test
    void anAnswerIsLookedAtOnlyIfItCanHaveUsedTooMuch() {
        clock.limitBy(TimeBasis.CPU);
        ask(LIMIT);
        int before = samples;
        long quick = LIMIT / TreeSampler.processors();
        assertEquals(quick, clock.charge(START + quick));
        assertEquals(before, samples);
        cpu = 81 * MS;
        assertEquals(-1, clock.charge(START + 85 * MS));
        assertEquals(85 * MS, clock.taken());
        assertEquals(before + 1, samples);
    }

    /** The referee did not run for 500 ms, and the bot computed all the time on all processors. */
    @Test
    void aBotThatKeepsTheProcessorsFromTheRefereeIsCharged() {
        ask(LIMIT);
        assertEquals(30, look(20, 0));
        cpu = 70 * TreeSampler.processors() * MS;
        assertTrue(look(520, 490) > 0);
        assertEquals(70 * MS, clock.taken());
        cpu = 90 * TreeSampler.processors() * MS;
        assertEquals(540.2, look(540, 0));
        assertEquals(-1, look(540.2, 0));
        assertEquals(90 * MS, clock.taken());
    }

    /** Its answer came before the watchdog was back. */
    @Test
    void anAnswerOfComputingTooLongIsLateAlsoIfTheWatchdogWas() {
        ask(LIMIT);
        look(20, 0);
        assertEquals(LIMIT, clock.charge(START + 300 * MS), "it slept, or the referee did");
        ask(LIMIT);
        look(20, 0);
        cpu = 81 * TreeSampler.processors() * MS;
        assertEquals(-1, clock.charge(START + 300 * MS));
        assertEquals(81 * MS, clock.taken());
    }

    /**
     * The frame is written at 160 ms, while the watchdog, which looked at the clock at 130, samples the processes: that
     * is 30 ms before the start. They have used 100 ms since the question began, in those 130.
     */
    @Test
    void cpuTimeUsedUpBeforeTheFrameIsWrittenIsNotToldInNegativeTimes() {
        clock.limitBy(TimeBasis.CPU);
        clock.begin(LIMIT, START, sample(START));
        cpu = 100 * MS;
        whileSampling = () -> clock.frameWritten(START + 160 * MS);
        assertEquals(-1, look(130, 0));
        assertEquals(130 * MS, clock.taken());
        TimeSpent spent = clock.spent(START + 130 * MS, clock.taken());
        assertEquals("no answer within 80 ms of CPU time (used 100 ms in 130 ms): computed all the time: an endless "
            + "loop, or too slow? [computed 100, waited 0 for a processor, 30 other]",
            FaultMessages.missed(spent, TimeBasis.CPU, false, 0, 1, 0));
    }
}
