package steward.bot.accounting;

import java.util.Map;

/**
 * Sample of a tree of processes at one moment: number of processes, CPU time, waiting of threads. All times in
 * nanoseconds.
 *
 * @param at        the moment, on the caller's clock
 * @param shown     whether the system shows any of it
 * @param processes how many processes there were
 * @param steps     CPU time of the processes since they began, with that of children they have waited for, in steps of
 *                  {@value #STEP} ns; a count is cut to whole steps, two of them for a process
 * @param threads   the living threads by their numbers; {@code null} if their times are not shown
 * @param idle      idle time of all processors of the machine since it started, in steps of {@value #STEP} ns; -1 if
 *                  not shown
 */
public record TreeSample(long at, boolean shown, int processes, long steps, Map<Long, ThreadTimes> threads, long idle) {

    /** The unit of the kernel's coarse counts, 1/100 s on all machines that Java runs on. */
    public static final long STEP = 10_000_000;

    /**
     * A thread.
     *
     * @param run      CPU time since it began
     * @param waited   time for which it was runnable and waited for a processor, up to when it last got one
     * @param slices   how often it has got one
     * @param runnable whether it runs or waits for a processor now
     * @param leader   whether it is the first of its process
     */
    public record ThreadTimes(long run, long waited, long slices, boolean runnable, boolean leader) {

        /** The first thread of a process. */
        public ThreadTimes(long run, long waited, long slices, boolean runnable) {
            this(run, waited, slices, runnable, true);
        }
    }

    /** Before the first process of a tree was started. */
    public static TreeSample beforeStart(long at, long idle) {
        return new TreeSample(at, true, 0, 0, Map.of(), idle);
    }
}
