package steward.bot.hold;

import java.util.ArrayDeque;
import java.util.Deque;
import steward.bot.accounting.TimeLedger;
import steward.bot.accounting.TreeSample;

/**
 * Meter of the CPU time that a bot uses while it is not asked. Only time between two samples of one wait counts, so
 * that none of the bot's own turn is included. Reads no clock and no files. Not thread-safe.
 */
public final class WaitingMeter {

    /** Length of the last time of waiting that is judged, in nanoseconds. */
    public static final long WINDOW = 100_000_000;

    /** Processors that a bot may use on average meanwhile: collectors and timers of an honest one take less. */
    static final double MOST_PROCESSORS = 0.25;

    /** Time seen that is enough to name a bot beside which another was late, in nanoseconds. */
    static final long LEAST_SEEN = 15_000_000;

    private record Interval(long passed, long used) { }

    private final Deque<Interval> last = new ArrayDeque<>();
    private long passed;
    private long used;
    private TreeSample before;
    private long exactBefore;
    private long waitOfBefore;

    /**
     * Adds a sample.
     *
     * @param wait  in which it was taken: waits that others follow have other numbers
     * @param exact CPU time until then of all that the bot ever started, in nanoseconds; -1 if only the sample knows
     */
    public void add(long wait, TreeSample sample, long exact) {
        if (before != null && wait == waitOfBefore && sample.shown() && sample.at() > before.at()) {
            TimeLedger ledger = new TimeLedger(before);
            ledger.add(sample);
            add(new Interval(sample.at() - before.at(),
                exact >= 0 && exactBefore >= 0 ? exact - exactBefore : ledger.probableCpu()));
        }
        before = sample.shown() ? sample : null;
        exactBefore = exact;
        waitOfBefore = wait;
    }

    private void add(Interval interval) {
        last.addLast(interval);
        passed += interval.passed();
        used += interval.used();
        while (passed - last.getFirst().passed() >= WINDOW) {
            Interval first = last.removeFirst();
            passed -= first.passed();
            used -= first.used();
        }
    }

    /** Processors that were used on average; 0 without samples. */
    public double processors() {
        return passed == 0 ? 0 : (double) used / passed;
    }

    /** True if the whole window was seen, and more than a quarter of one processor used in it. */
    public boolean burns() {
        return passed >= WINDOW && processors() > MOST_PROCESSORS;
    }

    /** True if the bot burns as far as was seen, at least for a moment: enough to play a game again, not to hold. */
    public boolean isSuspect() {
        return passed >= LEAST_SEEN && processors() > MOST_PROCESSORS;
    }

    /** Forgets what was seen. */
    public void reset() {
        last.clear();
        passed = 0;
        used = 0;
        before = null;
    }
}
