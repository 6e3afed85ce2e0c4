package steward.bot.process;

import java.util.function.LongFunction;
import java.util.function.Supplier;
import steward.bot.TimeBasis;
import steward.bot.TimeSpent;
import steward.bot.accounting.OwnThread;
import steward.bot.accounting.TimeLedger;
import steward.bot.accounting.TreeSample;
import steward.bot.accounting.TreeSampler;

/**
 * Clock of a player's current question, which decides when its time is up. The asking thread starts it; the watchdog
 * looks at it for the first time after a quarter of the limit, then every eighth. At the first look, and once more
 * before the end, it samples the bot's processes, so that a turn that is answered soon costs nothing. Times are passed
 * in, on the clock of {@link Watchdog#now}.
 *
 * <p>Time in which the referee itself did not run is not charged: any oversleeping of the watchdog by {@value #PAUSE}
 * ns or more. That covers a stopped or suspended referee, garbage collection, and a processor that was not free. When
 * the time is up, the watchdog checks once more whether the asking thread still sleeps in its read. If it does not,
 * data has arrived, and the thread first gets the processor to read it. So an answer that is in the pipe at the verdict
 * counts. Computing is charged in any case, as if the bot had had all processors.
 *
 * <p>On the basis {@link TimeBasis#UNSTARVED} the processes are sampled at each look, and their waiting for a processor
 * is not charged either. Both may be the same time: the longer of the two is left out.
 *
 * <p>Caveat: the watchdog reads the fields of the asking thread without a lock, at worst while the next question
 * begins. Its note is then about the next question, and true of it. It never decides wrongly, since the compare-and-set
 * in {@link Deadline} then fails.
 */
final class QuestionClock {

    /** A wake-up that is later than this, in nanoseconds, means that the referee did not run; below, it is usual. */
    static final long PAUSE = 1_000_000;

    /** Result of {@link #look} when the time is up. */
    static final long PASSED = 0;

    /** When the time is up, the asking thread is looked at a second time after so long: it may be between two reads. */
    private static final long SECOND_LOOK = 200_000;

    /** How long the asking thread gets to see what has come, in nanoseconds, before it is looked at again. */
    private static final long ATTENTION = 1_000_000;

    /** In all it gets so long, in nanoseconds: a bot must not hold the verdict up by sending byte for byte. */
    private static final long MOST_ATTENTION = 2_000_000_000;

    /** Between two looks, in nanoseconds. */
    private static final long LEAST_STEP = 1_000_000;

    private static final int QUARTER = 4;
    private static final int EIGHTH = 8;

    private final Supplier<OwnThread.State> asking;
    private final LongFunction<TreeSample> sampler;
    private TimeBasis basis = TimeBasis.WALL;
    private long strikeAfter = Long.MAX_VALUE;

    /** Written by the asking thread before the deadline is armed. */
    private long number;
    private long limit;
    private long start;
    private TreeSample baseline;
    private volatile boolean writing;

    /** Written by the watchdog: for which question and start, what was not charged, and what was seen. */
    private long observed;
    private long from;
    private long uncharged;
    private long taken;
    private long attention;
    private boolean asleep;
    private long observation;
    private volatile boolean unread;

    /** Guarded by this: what the processes did, and for which question. */
    private TimeLedger ledger;
    private long ledgerOf;
    private TimeSpent spent;
    private long spentOf;

    /** @param sampler what the bot's processes have done up to a moment */
    QuestionClock(Supplier<OwnThread.State> asking, LongFunction<TreeSample> sampler) {
        this.asking = asking;
        this.sampler = sampler;
    }

    void limitBy(TimeBasis other) {
        basis = other;
    }

    /** See {@link steward.bot.Player#strikeAfter}. */
    void strikeAfter(long nanos) {
        strikeAfter = nanos;
    }

    /** Returns where the time of an answer went that came within the limit, but counts as late; or {@code null}. */
    TimeSpent strike(long now, long charge) {
        return charge <= strikeAfter ? null : spentBeyond(now, charge);
    }

    private synchronized TimeSpent spentBeyond(long now, long charge) {
        observe(now);
        return ledger.spent(strikeAfter, charge, TreeSampler.processors(), false);
    }

    /**
     * A question begins; the frame has not been written.
     *
     * @param known what the processes had done by now, or {@code null} if it need not be known
     */
    void begin(long limitNanos, long now, TreeSample known) {
        number++;
        limit = limitNanos;
        start = now;
        baseline = known;
        writing = true;
    }

    /** True if the next question needs to know what the processes have done before. */
    boolean needsBaseline() {
        return basis != TimeBasis.WALL;
    }

    /** The frame is written: the clock starts. A program that was begun for it has hardly begun to start by now. */
    void frameWritten(long now) {
        start = now;
        writing = false;
    }

    /** Returns when the watchdog is to look for the first time. */
    long firstLook() {
        return later(start, limit / QUARTER);
    }

    /** Returns the time that the answer may take by the wall clock. */
    long wallLimit() {
        boolean backstop = basis != TimeBasis.WALL && limit < Long.MAX_VALUE / TimeBasis.BACKSTOP;
        return backstop ? limit * TimeBasis.BACKSTOP : limit;
    }

    private static long later(long time, long by) {
        return by < Long.MAX_VALUE - time ? time + by : Long.MAX_VALUE;
    }

    /**
     * The watchdog looks at a pending question.
     *
     * @param overslept by how much it has woken up later than it was to
     * @return when to look again, or {@link #PASSED}
     */
    long look(long now, long overslept) {
        if (observed != number || from != start) {
            observed = number;
            from = start;
            uncharged = 0;
            attention = 0;
            asleep = false;
            observation = 0;
            unread = false;
        }
        uncharged += overslept < PAUSE ? 0 : Math.max(0, Math.min(overslept, now - start));
        if (basis == TimeBasis.UNSTARVED) {
            return lookUnstarved(now);
        }
        long wall = wallLimit();
        long step = Math.max(LEAST_STEP, limit / EIGHTH);
        long quarter = limit / QUARTER;
        long charged = charged(now, step);
        taken = charged;
        if (charged < quarter) {
            return later(start + uncharged, quarter);
        }
        if (charged >= observation) {
            observation = nextObservation(now, charged, step);
            if (basis == TimeBasis.CPU && overCpu()) {
                taken = sampledSpan();             // by the clock it was not late, so that pauses are not of interest
                return PASSED;
            }
        }
        return charged < wall ? Math.min(now + step, later(start + uncharged, wall)) : lookOnceMore(now);
    }

    private long lookUnstarved(long now) {
        observe(now);
        long charged = unstarved(now);
        boolean inTime = charged < limit && now - start - uncharged < wallLimit();
        taken = charged < limit ? now - start - uncharged : charged;
        return inTime ? now + Math.max(LEAST_STEP, Math.min(limit / EIGHTH, limit - charged)) : lookOnceMore(now);
    }

    /** The time that has passed, without waiting for a processor, at the last sample. */
    private synchronized long unstarved(long now) {
        return Math.max(now - start - Math.max(uncharged, ledger.starved(TreeSampler.processors())), computed());
    }

    /** The time that has passed, without what is not charged, but at least that of {@link #computed}. */
    private long charged(long now, long step) {
        long charged = now - start - uncharged;
        if (uncharged < step) {
            return charged;
        }
        observe(now);
        return Math.max(charged, computed());
    }

    /**
     * Returns how long the processes must have been computing, if all processors were theirs. A bot whose threads keep
     * the referee from running is charged for that.
     */
    private long computed() {
        return cpu() / TreeSampler.processors();
    }

    /**
     * Samples the processes. A limit of the wall clock wants one sample more, shortly before it, to tell threads that
     * wait all the time from those that have just begun to; one of CPU time wants the next when it may be used up.
     *
     * @return when to sample next, in charged time
     */
    private long nextObservation(long now, long charged, long step) {
        boolean again = observe(now);
        if (basis == TimeBasis.CPU) {
            return later(charged, Math.max(step, (limit - cpu()) / TreeSampler.processors()));
        }
        return again ? Long.MAX_VALUE : Math.max(charged, limit - limit / EIGHTH);
    }

    /** Looks twice in a row whether the asking thread sleeps. */
    private long lookOnceMore(long now) {
        OwnThread.State state = asking.get();
        boolean before = asleep;
        asleep = state != OwnThread.State.AWAKE;
        if (!asleep && attention < MOST_ATTENTION) {
            attention += ATTENTION;
            return now + ATTENTION;
        }
        if (asleep && !before) {
            return now + SECOND_LOOK;
        }
        unread = writing;
        return PASSED;
    }

    /** True if there has been a sample in this question before. */
    private synchronized boolean observe(long now) {
        boolean begun = ledger != null && ledgerOf == number;
        if (!begun) {
            ledgerOf = number;
            ledger = new TimeLedger(baseline != null ? baseline : sampler.apply(now));
        }
        if (ledger.until() < now) {
            ledger.add(sampler.apply(now));
        }
        return begun;
    }

    private synchronized long cpu() {
        return ledger != null && ledgerOf == number ? ledger.cpu() : 0;
    }

    /** Returns how long the samples of the question are apart: CPU time is counted from before the frame is written. */
    private synchronized long sampledSpan() {
        return ledger.until() - ledger.since();
    }

    /** True if the processes have used up their CPU time. */
    private boolean overCpu() {
        return cpu() > limit;
    }

    /**
     * Returns the charge for an answer that has come before the watchdog found the time to be up.
     *
     * @return in nanoseconds; -1 if it is too much, and then {@link #taken} says how much
     */
    long charge(long now) {
        long passed = now - start;
        boolean cpuLimit = basis == TimeBasis.CPU;
        // On all processors together no more CPU time can be used than passes: quick answers need no sample.
        if (passed <= (cpuLimit ? limit / TreeSampler.processors() : basis == TimeBasis.UNSTARVED
                ? Math.min(limit, strikeAfter) : limit)) {
            return passed;
        }
        observe(now);
        if (basis == TimeBasis.UNSTARVED && computed() <= limit) {
            return Math.min(limit, unstarved(now));
        }
        if (cpuLimit ? overCpu() : computed() > limit) {
            taken = cpuLimit ? passed : computed();
            return -1;
        }
        return Math.min(passed, wallLimit());
    }

    /** True if the time was up while the frame could not be written, because the bot did not read. */
    boolean unread() {
        return unread;
    }

    long passed(long now) {
        return now - start;
    }

    /** Returns how long the bot had taken at the verdict, without what is not charged. */
    long taken() {
        return taken;
    }

    /**
     * Returns where the time of a missed deadline went. The first call looks at the processes for the last time, so
     * that it has to come before they are killed; later ones return the same.
     *
     * @param taken what was charged
     */
    synchronized TimeSpent spent(long now, long taken) {
        if (spentOf != number) {
            spentOf = number;
            observe(now);
            boolean overCpu = basis == TimeBasis.CPU && overCpu();
            boolean unstarved = basis == TimeBasis.UNSTARVED && taken < wallLimit();
            spent = unstarved ? ledger.spent(limit, sampledSpan(), TreeSampler.processors(), false).withoutWaiting()
                : ledger.spent(overCpu ? limit : wallLimit(), taken, TreeSampler.processors(), overCpu);
        }
        return spent;
    }

    TimeBasis basis() {
        return basis;
    }

    long started() {
        return start;
    }
}
