package steward.bot.accounting;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import steward.bot.TimeSpent;
import steward.bot.TimeSpent.Shows;
import steward.bot.accounting.TreeSample.ThreadTimes;

/** Samples are written down by hand, in milliseconds; the machine has 2 processors. */
class TimeLedgerTest {

    private static final long MS = 1_000_000;

    private static ThreadTimes thread(long run, long waited, long slices, boolean runnable) {
        return new ThreadTimes(run * MS, waited * MS, slices, runnable);
    }

    private static TreeSample sample(long at, long steps, long idle, Map<Long, ThreadTimes> threads) {
        return new TreeSample(at * MS, true, 1, steps * MS, threads, idle * MS);
    }

    /** A sample of one thread. */
    private static TreeSample one(long at, long steps, long idle, long run, long waited, long slices,
                                  boolean runnable) {
        return sample(at, steps, idle, Map.of(7L, thread(run, waited, slices, runnable)));
    }

    /** Of 75 ms, the last 57 were seen. */
    private static TimeSpent spent(TimeLedger ledger) {
        return ledger.spent(75 * MS, 75 * MS, 2, false);
    }

    /** @param parts unobserved, computed, waited and other */
    private static void assertParts(String parts, TimeSpent spent) {
        assertEquals(parts, spent.unobserved() / MS + " " + spent.computed() / MS + " " + spent.waited() / MS + " "
            + spent.other() / MS);
        assertEquals(spent.taken(), spent.unobserved() + spent.computed() + spent.waited() + spent.other());
    }

    /** Samples one after the other; what was unobserved, computed, waited and other; whether the machine starved it. */
    static Stream<Arguments> partsOfThe75() {
        double each = 114 / 32.0;
        return Stream.of(
            arguments("others keep both processors busy: it ran 3 of 57 ms and waited 50",
                List.of(one(18, 100, 900, 100, 40, 5, false), one(75, 100, 900, 103, 90, 9, false)), "18 3 50 4", true),
            arguments("runnable at all samples, and it never ran: time that the kernel has not yet counted",
                List.of(one(18, 0, 0, 10, 0, 5, true), one(30, 0, 0, 10, 0, 5, true), one(75, 0, 0, 10, 0, 5, true)),
                "18 0 57 0", true),
            arguments("the kernel adds a whole wait of 60 ms, also from before, when the thread gets a processor",
                List.of(one(18, 0, 0, 10, 0, 5, true), one(58, 0, 0, 10, 0, 5, true), one(75, 0, 0, 22, 60, 6, true)),
                "18 12 45 0", true),
            arguments("57 ms of computing while the other processor was idle",
                List.of(one(18, 0, 0, 0, 0, 1, true), one(75, 0, 57, 57, 0, 1, true)), "18 57 0 0", false),
            arguments("32 threads on 2 processors wait for one another",
                List.of(sample(18, 0, 0, many(32, 0, 0)), sample(75, 0, 0, many(32, each, 57 - each))),
                "18 57 0 0", false),
            arguments("two threads, each a third of a processor beside four loops",
                List.of(sample(18, 0, 0, many(2, 0, 0)), sample(75, 0, 0, many(2, 19, 38))), "18 19 38 0", true));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("partsOfThe75")
    void timeIsDividedUp(String what, List<TreeSample> samples, String parts, boolean isStarved) {
        TimeLedger ledger = new TimeLedger(samples.get(0));
        samples.subList(1, samples.size()).forEach(ledger::add);
        assertParts(parts, spent(ledger));
        assertEquals(isStarved, spent(ledger).starved());
        assertEquals(Shows.ALL, spent(ledger).shows());
    }

    /** Each process of a chain lives for less than is between two looks: one is seen, and it stands for the others. */
    @Test
    void aProcessThatHasBegunAndRunsStandsForThoseBeforeIt() {
        TimeLedger ledger = new TimeLedger(one(0, 0, 0, 5, 0, 5, false));
        ledger.add(sample(20, 0, 0, Map.of(7L, thread(5, 0, 5, false), 8L, thread(1, 0, 1, true))));
        ledger.add(sample(40, 0, 0, Map.of(7L, thread(5, 0, 5, false), 9L, thread(2, 0, 1, false))));
        assertEquals((20 + 2) * MS, ledger.probableCpu(), "the last does not run");
        assertEquals((1 + 2) * MS, ledger.cpu(), "for a verdict only what was seen counts");
    }

    /** Ten samples of a process that ran and waited, and of others beside it, each of which has just begun. */
    private static TimeLedger chains(int count, double run, double waited, double child) {
        TimeLedger ledger = new TimeLedger(one(0, 0, 0, 0, 0, 0, false));
        for (int k = 1; k <= 10; k++) {
            Map<Long, ThreadTimes> threads = new HashMap<>(Map.of(7L,
                new ThreadTimes(Math.round(k * run * MS), Math.round(k * waited * MS), k, false)));
            for (int chain = 0; chain < count; chain++) {
                threads.put(100L * k + chain, new ThreadTimes(Math.round(child * MS),
                    Math.round(MS * (count == 1 ? 7 : 1)), 1, true));
            }
            ledger.add(sample(10L * k, 0, 0, threads));
        }
        return ledger;
    }

    /** Its children compute on 2 processors, for some ms each; nobody waits for them: no count has what they used. */
    @Test
    void aBotThatStarvesItselfByChainsOfProcessesIsChargedForIt() {
        TimeLedger ledger = chains(3, 4, 6, 2);
        assertEquals(0, ledger.starved(2));
        assertFalse(ledger.spent(75 * MS, 100 * MS, 2, false).doubtful());
    }

    /** A shell that starts programs one after the other, beside others' load on both processors. */
    @Test
    void aBotThatStartsOneProgramAfterTheOtherIsStarvedByOthers() {
        assertEquals(70, chains(1, 0, 0, 3).starved(2) / MS);
    }

    /** 40 ms by the count of 9 processes, all but one of which slept. */
    @Test
    void oneStepIsCutHoweverManyProcessesThereAre() {
        Map<Long, ThreadTimes> asleep = Map.of(7L, thread(5, 0, 5, false));
        TimeLedger ledger = new TimeLedger(new TreeSample(0, true, 9, 0, asleep, 0));
        ledger.add(new TreeSample(20 * MS, true, 9, 40 * MS, asleep, 0));
        assertEquals(30 * MS, ledger.probableCpu());
        assertEquals(0, ledger.cpu());
    }

    /** Four busy loops beside it, which get 4 of 36 parts: the bot's own threads are what it waits for. */
    @Test
    void threadsThatStarveThemselvesBesideOthersCompute() {
        double each = 114 / 36.0;
        TimeLedger ledger = new TimeLedger(sample(18, 0, 0, many(32, 0, 0)));
        ledger.add(sample(75, 0, 0, many(32, each, 57 - each)));
        TimeSpent spent = spent(ledger);
        assertFalse(spent.starved(), spent.text());
        assertEquals(4 * each / 2 * MS, spent.waited(), MS, "the share of the others, on two processors");
    }

    private static Map<Long, ThreadTimes> many(int count, double run, double waited) {
        Map<Long, ThreadTimes> threads = new HashMap<>();
        for (long k = 1; k <= count; k++) {
            threads.put(k, new ThreadTimes(Math.round(run * MS), Math.round(waited * MS), k, false));
        }
        return threads;
    }

    /** A child has come, computed 30 ms and gone: the parent's coarse count has them, cut to steps. */
    @Test
    void timeOfThoseThatHaveEndedComesInSteps() {
        TimeLedger ledger = new TimeLedger(one(18, 100, 0, 1, 0, 5, false));
        ledger.add(one(75, 150, 84, 2, 0, 6, false));
        assertEquals(30 * MS, ledger.cpu(), "50 ms less two steps that may be rounding");
        assertParts("18 30 0 27", spent(ledger));
        assertEquals(Shows.ALL_IN_STEPS, spent(ledger).shows());
    }

    @Test
    void aThreadThatHasBegunSinceCountsWhole() {
        TimeLedger ledger = new TimeLedger(one(18, 0, 0, 500, 0, 5, false));
        ledger.add(sample(75, 0, 114, Map.of(7L, thread(500, 0, 5, false), 8L, thread(20, 0, 1, false))));
        assertEquals(20 * MS, ledger.cpu());
    }

    @Test
    void withoutCountsOfThreadsThereAreSteps() {
        TimeLedger ledger = new TimeLedger(sample(18, 100, 0, null));
        ledger.add(sample(75, 130, 0, null));
        assertParts("18 30 0 27", spent(ledger));
        assertEquals(Shows.STEPS, spent(ledger).shows());
    }

    @Test
    void whereNothingIsShownNothingIsKnown() {
        TimeLedger ledger = new TimeLedger(new TreeSample(18 * MS, false, 0, 0, null, -1));
        ledger.add(new TreeSample(75 * MS, false, 0, 0, null, -1));
        assertEquals(TimeSpent.unknown(75 * MS, 75 * MS), spent(ledger));
    }

    /** It has waited, but how busy others were is not shown: then several threads have waited for one another. */
    @Test
    void withoutIdleTimeNoMachineIsStarved() {
        TimeLedger ledger = new TimeLedger(new TreeSample(18 * MS, true, 1, 0, many(2, 0, 0), -1));
        ledger.add(new TreeSample(75 * MS, true, 1, 0, many(2, 19, 38), -1));
        assertFalse(spent(ledger).starved());
    }

    /** From its start on, everything a process did is seen. */
    @Test
    void fromTheStartOfAProgramNothingIsUnobserved() {
        TimeLedger ledger = new TimeLedger(TreeSample.beforeStart(0, 0));
        ledger.add(one(75, 10, 130, 15, 3, 5, false));
        assertParts("0 15 3 57", spent(ledger));
    }

    /** Of 570 ms between the samples 57 are charged; in all it ran for a fifth and waited for two. */
    @Test
    void whereTimeIsNotChargedThePartsAreInProportion() {
        TimeLedger ledger = new TimeLedger(one(18, 0, 0, 0, 0, 5, false));
        ledger.add(one(588, 0, 0, 114, 228, 9, false));
        assertEquals(114 * MS, ledger.cpu());
        assertParts("0 15 30 30", spent(ledger));
        assertParts("0 11 22 22", ledger.spent(75 * MS, 57 * MS, 2, false));
    }

    /** Idle time is known from 20 ms on: of 2 * 55 ms nothing was idle, 8 were the bot's. */
    @Test
    void aBaselineWithoutIdleTimeIsMadeUpForByTheNextSample() {
        TimeLedger ledger = new TimeLedger(new TreeSample(0, true, 1, 0, many(2, 0, 0), -1));
        ledger.add(sample(20, 0, 500, many(2, 0, 0)));
        ledger.add(sample(75, 0, 500, many(2, 4, 50)));
        assertParts("0 5 69 0", spent(ledger));
    }
}
