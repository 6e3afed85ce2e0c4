package steward.physics.event;

import java.util.Arrays;
import steward.physics.ImpactLaw;
import steward.physics.time.SimultaneousImpacts;

/**
 * Queue of the predicted impacts of a scan, in the order of time. Impacts within a window of the earliest happen
 * together, ties in the order of the scan; or impacts happen one at a time, and ties go to the lowest pair, bodies
 * before walls. An impact that is offered after an earlier one of which it is out of the window is not kept.
 */
sealed class ImpactQueue permits ExactImpactQueue {

    private final boolean batched;
    private final double window;
    private double[] times = new double[16];
    private double[] lows = new double[16];
    private int[] firsts = new int[16];
    private int[] seconds = new int[16];
    private int size;

    /** @param batched whether impacts happen together; otherwise the window is 0 */
    ImpactQueue(boolean batched, double window) {
        this.batched = batched;
        this.window = window;
    }

    ImpactQueue(ImpactLaw law) {
        this(law.batchWindow() > 0, law.batchWindow());
    }

    void clear() {
        size = 0;
    }

    /** Offers an impact at an absolute time within the turn; b is an index, or {@code ~wall}. */
    void offer(double time, int a, int b) {
        if (mayBeNext(time)) {
            insert(time, 0, a, b);
        }
    }

    /** True unless an impact at this time is out of the window of the earliest. */
    final boolean mayBeNext(double time) {
        return size == 0 || time - times[0] <= window;
    }

    final void insert(double time, double low, int a, int b) {
        if (size == times.length) {
            times = Arrays.copyOf(times, 2 * size);
            lows = Arrays.copyOf(lows, 2 * size);
            firsts = Arrays.copyOf(firsts, 2 * size);
            seconds = Arrays.copyOf(seconds, 2 * size);
        }
        int k = size++;
        for (; k > 0 && isBefore(time, low, a, b, k - 1); k--) {
            times[k] = times[k - 1];
            lows[k] = lows[k - 1];
            firsts[k] = firsts[k - 1];
            seconds[k] = seconds[k - 1];
        }
        times[k] = time;
        lows[k] = low;
        firsts[k] = a;
        seconds[k] = b;
    }

    private boolean isBefore(double time, double low, int a, int b, int k) {
        return time != times[k] ? time < times[k] : low != lows[k] ? low < lows[k]
            : !batched && SimultaneousImpacts.rank(a, b) < SimultaneousImpacts.rank(firsts[k], seconds[k]);
    }

    /** The number of impacts that happen next, which are the first; 0 if none was offered. */
    final int nextBatch() {
        int count = Math.min(size, 1);
        while (batched && count < size && times[count] - times[0] <= window) {
            count++;
        }
        return count;
    }

    double time(int k) {
        return times[k];
    }

    /** The low part of a time that is a double-double. */
    final double low(int k) {
        return lows[k];
    }

    final int a(int k) {
        return firsts[k];
    }

    final int b(int k) {
        return seconds[k];
    }
}
