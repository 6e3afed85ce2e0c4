package steward.bot.accounting;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import steward.bot.TimeSpent;
import steward.bot.accounting.TreeSample.ThreadTimes;

/**
 * Ledger of the time that a tree of processes used between the first and the last of several samples. Reads no clock
 * and no files.
 *
 * <p>The kernel counts a thread's waiting for a processor only when the thread gets one. If a thread is runnable at two
 * samples and did not run in between, it has waited all the time; the kernel's later addition for it is then left out.
 * If it ran and is runnable at the end, it may have waited for the rest: that is open until it runs again.
 */
public final class TimeLedger {

    private final TreeSample first;
    private TreeSample last;
    /** The first sample that has the idle time of the machine, or {@link #first}. */
    private TreeSample firstIdle;
    private long run;
    private long begun;
    private long waited;
    /** CPU time that processes may have used which began and ended between two samples, in nanoseconds. */
    private long unseen;
    /** Threads that ran or waited. */
    private final Set<Long> active = new HashSet<>();
    /** Nanoseconds counted for threads that still wait, by thread. */
    private final Map<Long, Long> pending = new HashMap<>();
    /** Nanoseconds for which threads may have waited since they last ran, without what is counted, by thread. */
    private final Map<Long, Long> open = new HashMap<>();

    public TimeLedger(TreeSample first) {
        this.first = first;
        last = first;
        firstIdle = first;
    }

    /** The moment of the first sample. */
    public long since() {
        return first.at();
    }

    /** The moment of the last. */
    public long until() {
        return last.at();
    }

    /** One more sample, later than those before. */
    public void add(TreeSample next) {
        if (!next.shown()) {
            return;
        }
        if (next.threads() != null && last.threads() != null) {
            long passed = Math.max(0, next.at() - last.at());
            next.threads().forEach((number, now) -> add(number, last.threads().get(number), now, passed));
            open.keySet().retainAll(next.threads().keySet());
        }
        firstIdle = firstIdle.idle() < 0 ? next : firstIdle;
        last = next;
    }

    /** @param before {@code null} for a thread that has begun since */
    private void add(Long number, ThreadTimes before, ThreadTimes now, long passed) {
        boolean known = before != null && before.run() <= now.run();
        long ran = known ? now.run() - before.run() : now.run();
        long queued = known ? now.waited() - before.waited() : now.waited();
        long counted = pending.getOrDefault(number, 0L);
        boolean still = known && before.runnable() && now.runnable() && ran == 0 && now.slices() == before.slices();
        long share = still ? passed : Math.max(0, queued - counted);
        share = Math.max(0, Math.min(share, passed - ran + (still ? 0 : open.getOrDefault(number, 0L))));
        if (!still) {
            open.put(number, now.runnable() ? Math.max(0, passed - ran - share) : 0);
        }
        pending.put(number, still ? counted + passed : 0);
        run += ran;
        begun += before == null && now.runnable() ? Math.max(0, passed - ran) : 0;
        unseen += before == null && now.leader() && now.runnable() ? Math.max(0, passed - ran) : 0;
        waited += share;
        if (ran + share > 0) {
            active.add(number);
        }
    }

    /**
     * CPU time used between the first sample and the last, all threads and processes summed: the finer count of living
     * threads, or that of the processes, less what its steps may have added, where that is more.
     */
    public long cpu() {
        return Math.max(run, inSteps(2L * last.processes()));
    }

    /**
     * CPU time used between the first sample and the last as it probably was: cut by one step only, and what is begun
     * anew and runs at a sample stands for others before it, which have ended unseen. Right on average, and more than
     * {@link #cpu} where processes come and go; not for a verdict.
     */
    public long probableCpu() {
        return Math.max(run + begun, inSteps(1));
    }

    /** @param cut the steps that are left out, where there is a finer count as well */
    private long inSteps(long cut) {
        long counted = last.steps() - first.steps();
        boolean only = last.threads() == null || first.threads() == null;
        return Math.max(0, only ? counted : counted - cut * TreeSample.STEP);
    }

    /*
     * From sums over threads to parts of the wall clock. In E of the wall clock the threads ran for C in all and waited
     * for W. So C + W was wanted; k = (C + W) / E threads were runnable on average, and of those no more can run at
     * once than there are processors. One unit of wall clock is therefore k units of threads, k within 1..processors.
     *
     * Of the waiting, others caused no more than the CPU time they used: O = processors * E - idle - C. The rest, up to
     * W, the bot's own threads and children caused: it is counted as computing. A single active thread waits for
     * no thread of its own. Where processes come and go, the CPU time of some is in no count: it is not taken for that
     * of others, so that a bot cannot excuse itself by a chain of them.
     *
     * Where part of the time is not charged, since the referee did not run, the parts are those of all the time between
     * the samples, in proportion.
     */

    /**
     * The parts of a missed deadline.
     *
     * @param limit   that was missed
     * @param taken   what had passed at the verdict
     * @param overCpu whether the limit was one of CPU time
     */
    public TimeSpent spent(long limit, long taken, int processors, boolean overCpu) {
        long passed = last.at() - first.at();
        if (!first.shown() || last == first || passed <= 0) {
            return TimeSpent.unknown(limit, taken);
        }
        boolean threads = last.threads() != null && first.threads() != null;
        long observed = Math.min(taken, passed);
        double charged = (double) observed / passed;
        double cpu = cpu();
        double side = side(processors, cpu + waited, passed);
        double byOthers = byOthers(processors, cpu, waited);
        long queued = Math.min(observed, Math.round(charged * byOthers / side));
        long computed = Math.min(observed - queued, Math.round(charged * (cpu + waited - byOthers) / side));
        TimeSpent.Shows shows = !threads ? TimeSpent.Shows.STEPS
            : cpu > run ? TimeSpent.Shows.ALL_IN_STEPS : TimeSpent.Shows.ALL;
        return new TimeSpent(limit, taken, taken - observed, computed, queued, observed - queued - computed,
            Math.round(cpu), shows, overCpu);
    }

    /**
     * Waiting for a processor that programs outside of the tree used, between the first sample and the last, as a part
     * of the wall clock; what is open is taken for waiting.
     */
    public long starved(int processors) {
        long passed = last.at() - first.at();
        if (passed <= 0) {
            return 0;
        }
        double cpu = cpu();
        double all = waited + open.values().stream().mapToLong(each -> each).sum();
        return Math.min(passed, Math.round(byOthers(processors, cpu, all) / side(processors, cpu + all, passed)));
    }

    /** Threads that were runnable on average, as many as can run at once. */
    private static double side(int processors, double wanted, long passed) {
        return Math.max(1, Math.min(processors, wanted / passed));
    }

    private double byOthers(int processors, double cpu, double queued) {
        return active.size() <= 1 && unseen == 0 ? queued : Math.min(queued, othersCpu(processors, cpu));
    }

    /** CPU time of processes outside the tree; 0 where the system does not show it. */
    private double othersCpu(int processors, double cpu) {
        if (firstIdle.idle() < 0 || last.idle() < 0) {
            return 0;
        }
        double all = (double) processors * (last.at() - firstIdle.at());
        return Math.max(0, all - (last.idle() - firstIdle.idle()) - cpu - unseen);
    }
}
