package steward.bot.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Locale;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.bot.FaultMessages;
import steward.bot.TimeBasis;
import steward.bot.TimeSpent;
import steward.bot.accounting.OwnThread;
import steward.bot.accounting.TreeSample;
import steward.bot.accounting.TreeSample.ThreadTimes;
import steward.bot.accounting.TreeSampler;

/**
 * When a question's time is up. The clock, the asking thread and the bot's processes are numbers that a test sets: a
 * limit of 80 ms, of which a quarter is 20 and an eighth 10. Rows tell a question in steps, in ms after its start:
 * {@code 20>30} is a look at 20, of which the next is at 30, {@code 520/490>530} one that was to come 490 ms earlier,
 * and {@code end} the end of the question.
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

    /** Takes the steps of a question, told with blanks between them. */
    private void play(String steps) {
        for (String step : steps.split(" +")) {
            String[] words = step.split("[=>@]");
            double number = words.length > 1 && !words[1].equals("end") ? Double.parseDouble(words[1]) : -1;
            switch (words[0]) {
                case "begin" -> clock.begin(LIMIT, START, null);
                case "ask" -> ask(LIMIT);
                case "written" -> clock.frameWritten(START + Math.round(number * MS));
                case "asleep", "awake", "unknown" -> asking = OwnThread.State.valueOf(step.toUpperCase(Locale.ROOT));
                case "cpu" -> cpu = Math.round(number * MS);
                case "waited" -> waited = Math.round(number * MS);
                case "first" -> assertEquals(number, (clock.firstLook() - START) / (double) MS, step);
                case "samples" -> assertEquals(number, samples, step);
                case "taken" -> assertEquals(number, clock.taken() / (double) MS, step);
                case "charge" -> assertEquals(Double.parseDouble(words[2]),
                    clock.charge(START + Math.round(number * MS)) / (double) MS, step);
                case "unread", "read" -> assertEquals(step.equals("unread"), clock.unread(), step);
                default -> {
                    String[] look = words[0].split("/");
                    double next = look(Double.parseDouble(look[0]), look.length > 1 ? Double.parseDouble(look[1]) : 0);
                    assertEquals(words.length > 1 ? number : next, next, step + " of " + steps);
                }
            }
        }
    }

    @ParameterizedTest(name = "{0}")
    @CsvSource(delimiter = '|', textBlock = """
        after a quarter, then every eighth | ask first=20 5>20 samples=0 20>30 samples=1 30>40
        a search that uses most of its time pays for one look | ask 20 69.9>79.9 samples=1 70>80 samples=2 75>80 \
        samples=2
        late if it sleeps at two looks, between which it may have been between two reads | ask 80>80.2 80.2>end read \
        taken=80.2
        an answer in the pipe is read first, and charged what the bot had | ask awake 80>81 89>90 charge@89=80 asleep \
        90>90.2 90.2>end
        where threads are not shown, late as if it slept | ask unknown 80>80.2 80.2>end
        the referee was stopped from 20.5 to 520, noticed by the look of 30 | ask 20>30 520/490>530 taken=30 565>570 \
        570>570.2 570.2>end
        a pause before the question is none of its | ask 5/400>25 taken=0
        a wake-up that is a millisecond late is usual | ask 20.9/0.9 taken=20.9
        the frame starts the clock; what was not charged before has nothing to do with it | begin 50/30 written=60 \
        65>80 taken=5
        a frame that cannot be written: awake the referee waits for a processor, asleep the pipe is full | begin awake \
        80>81 asleep 81>81.2 81.2>end unread
        """)
    void looksOfAQuestion(String what, String steps) {
        play(steps);
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

    @Test
    void theNextQuestionStartsAnew() {
        play("ask 520/490");
        clock.begin(LIMIT, START + 600 * MS, null);
        play("written=600 601>620 taken=1");
    }

    /** The referee needed 70 ms to start the program and to write: that is not the program's time. */
    @Test
    void theFirstClockStartsWithTheFrameAsWell() {
        clock.begin(LIMIT, START, TreeSample.beforeStart(START, 0));
        play("written=70 145>150 150>150.2 150.2>end taken=80.2");
        assertEquals(0, clock.spent(START + 151 * MS, clock.taken()).unobserved(), "all is known from the start");
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
        play("ask cpu=7 20 cpu=57");
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
        play("cpu=500 ask cpu=580 190>200 cpu=581 200>end");
        TimeSpent spent = clock.spent(START + 200 * MS, 200 * MS);
        assertTrue(spent.overCpu());
        assertEquals(81 * MS, spent.cpu());
        assertEquals(LIMIT, spent.limit());
    }

    /** The time told is the time that has passed, in which the CPU time was used; the referee's pause is part of it. */
    @Test
    void aPauseDoesNotShortenTheTimeInWhichCpuTimeWasUsed() {
        clock.limitBy(TimeBasis.CPU);
        play("ask cpu=90 130/110>end taken=130");
    }

    /** 60 ms are left at 30 ms; the processors together need so long for them, and an eighth at least. */
    @Test
    void cpuTimeIsLookedAtWhenItMayBeUsedUp() {
        clock.limitBy(TimeBasis.CPU);
        play("ask cpu=20 30");
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
        play("ask first=20 795>800 800>800.2 800.2>end");
        TimeSpent spent = clock.spent(START + 801 * MS, 801 * MS);
        assertFalse(spent.overCpu());
        assertEquals(10 * LIMIT, spent.limit());
    }

    /** It has computed for 60 of its 80 ms when the clock says 200; then for 82, and is late on any machine. */
    @Test
    void waitingForAProcessorIsNotChargedWhereTheMachineIsNotTo() {
        clock.limitBy(TimeBasis.UNSTARVED);
        play("ask cpu=5 waited=15 20>30 cpu=60 waited=140 200>210 charge@200=60 cpu=82 waited=168 250>250.2 250.2>end");
        TimeSpent spent = clock.spent(START + 251 * MS, clock.taken());
        assertFalse(spent.doubtful());
        assertEquals(0, spent.waited());
        assertEquals(82, spent.computed() / MS);
        assertFault("no answer within 80 ms, without waiting for a processor (waited 83 ms): computed "
            + "all the time: an endless loop, or too slow? [computed 82, waited 0 for a processor, ", spent);
    }

    private void assertFault(String start, TimeSpent spent) {
        String fault = FaultMessages.missed(spent, clock.basis(), false, 0, 1, 0);
        assertTrue(fault.startsWith(start), fault);
    }

    /** Sleeping is charged: it would be late on any machine. */
    @Test
    void aBotThatSleepsIsLateWhereTheMachineIsNotChargedToo() {
        clock.limitBy(TimeBasis.UNSTARVED);
        play("ask waited=5 75>85 85>85.2 85.2>end");
    }

    /** The machine never lets it run: ten times the limit are enough, and it is not the bot's fault. */
    @Test
    void notBeingLetRunAtAllEndsAfterTenTimesTheLimit() {
        clock.limitBy(TimeBasis.UNSTARVED);
        play("ask waited=790 799>809 800>800.2 800.2>end");
        TimeSpent spent = clock.spent(START + 801 * MS, clock.taken());
        assertTrue(spent.starved());
        assertFault("no answer within 800 ms (waited 801 ms): the machine was busy: not its fault", spent);
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
        play("ask 20>30");
        cpu = 70 * TreeSampler.processors() * MS;
        assertTrue(look(520, 490) > 0);
        assertEquals(70 * MS, clock.taken());
        cpu = 90 * TreeSampler.processors() * MS;
        play("540>540.2 540.2>end taken=90");
    }

    /** Its answer came before the watchdog was back. */
    @Test
    void anAnswerOfComputingTooLongIsLateAlsoIfTheWatchdogWas() {
        play("ask 20 charge@300=80 ask 20");
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
        play("130>end taken=130");
        assertFault("no answer within 80 ms of CPU time (used 100 ms in 130 ms): computed all the time: an endless "
            + "loop, or too slow? [computed 100, waited 0 for a processor, 30 other]",
            clock.spent(START + 130 * MS, clock.taken()));
    }
}
