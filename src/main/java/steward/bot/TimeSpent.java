package steward.bot;

/**
 * Breakdown of the time that a bot program took to answer, as far as the kernel shows it: computing, waiting for a
 * processor, other. All times are in nanoseconds of real time; {@code unobserved + computed + waited + other} is {@code
 * taken}.
 *
 * <p>Times of several threads that pass at once count once: two threads that compute at the same time for 10 ms have
 * computed for 10 ms, since no more real time passed.
 *
 * @param limit      what was allowed by the wall clock, or, with {@code overCpu}, of CPU time
 * @param taken      what had passed at the verdict, without the time in which the referee did not run
 * @param unobserved the first part of it, before the first look at the bot's processes
 * @param computed   on a processor, or waiting for one that the bot's own threads or child processes used
 * @param waited     runnable, while processes outside the bot's own tree used the processors; 0 if not shown
 * @param other      the rest: asleep, waiting for a disk, another process or a lock
 * @param cpu        CPU time used since the first look, all threads and processes summed
 * @param shows      which of these the kernel shows
 * @param overCpu    whether the limit was one of CPU time, and was exceeded
 */
public record TimeSpent(long limit, long taken, long unobserved, long computed, long waited, long other, long cpu,
                        Shows shows, boolean overCpu) {

    /** Words of a late answer for which others are to blame. */
    public static final String NOT_ITS_FAULT = "the machine was busy: not its fault";

    /** Parts that the kernel shows. */
    public enum Shows {
        /** None. */
        NOTHING,
        /** CPU time in steps of 10 ms, and not who waits for a processor: that is part of {@code other}. */
        STEPS,
        /**
         * All, but some of the CPU time only in steps of 10 ms: threads or processes have ended meanwhile, of which the
         * kernel keeps no finer count.
         */
        ALL_IN_STEPS,
        /** All, in nanoseconds. */
        ALL
    }

    private static final double NANOS_PER_MS = 1e6;
    private static final double MOST_OF_IT = 0.8;
    /** A bot that uses nine tenths of its limit is late after so much waiting, as a share of the limit. */
    private static final int DOUBT = 10;

    /** Nothing is known but how long it took. */
    public static TimeSpent unknown(long limit, long taken) {
        return new TimeSpent(limit, taken, taken, 0, 0, 0, 0, Shows.NOTHING, false);
    }

    /**
     * True if the machine was starved: the bot waited at least half of its limit for a processor while others used
     * them. A bot that used up its CPU time is late by itself.
     */
    public boolean starved() {
        return !overCpu && waited + waitedUnobserved() >= limit / 2;
    }

    /**
     * True if it may have been late only since it waited for a processor while others used them: for a tenth of its
     * limit. A game of which that is true is played again, see {@link TimeBasis#UNSTARVED}.
     */
    public boolean doubtful() {
        return !overCpu && waited + waitedUnobserved() >= limit / DOUBT;
    }

    /** Returns this without the waiting for a processor, of an answer that was late all the same. */
    public TimeSpent withoutWaiting() {
        return new TimeSpent(limit, Math.max(0, taken - waited), unobserved, computed, 0, other, cpu, shows, overCpu);
    }

    /** Waiting before the first look, estimated: then as later, waiting is a share of the time to wait and compute. */
    private long waitedUnobserved() {
        return waited == 0 ? 0 : Math.round((double) unobserved * waited / (waited + computed));
    }

    /** Words for a beginner, and the figures in brackets, as far as the kernel shows them. */
    public String text() {
        if (shows == Shows.NOTHING) {
            return "this system does not show what the bot did meanwhile";
        }
        String words = words();
        return words.isEmpty() ? figures() : words + " [" + figures() + "]";
    }

    private String words() {
        double observed = taken - unobserved;
        return starved() ? NOT_ITS_FAULT
            : overCpu || computed >= MOST_OF_IT * observed ? "computed all the time: an endless loop, or too slow?"
            : other >= observed / 2 && shows != Shows.STEPS ? "computed for " + ms(computed) + " ms, then waited, "
                + "as for input that nobody had sent: does it read too much, or not flush?"
            : doubtful() ? "the machine was busy: perhaps not its fault"
            : "";
    }

    /**
     * {@code computed 2, waited 53 for a processor, 2 other, 19 before the first look}, in whole milliseconds; what the
     * kernel does not show is named.
     */
    private String figures() {
        long first = ms(unobserved);
        long worked = ms(computed);
        long queued = ms(waited);
        long rest = Math.max(0, ms(taken) - first - worked - queued);
        String steps = shows == Shows.ALL ? "" : " (in steps of 10 ms)";
        String parts = "computed " + worked + steps + (shows == Shows.STEPS
            ? ", " + rest + " other (this system does not show waiting for a processor)"
            : ", waited " + queued + " for a processor, " + rest + " other");
        return first == 0 ? parts : parts + ", " + first + " before the first look";
    }

    private static long ms(long nanos) {
        return Math.round(nanos / NANOS_PER_MS);
    }
}
