package steward.physics.event;

import java.util.Arrays;
import steward.numerics.DoubleDouble;
import steward.numerics.ErrorFree;
import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.ImpactLaw;
import steward.physics.time.ContactDistance;
import steward.physics.time.ExactPairs;
import steward.physics.time.ExactWalls;
import steward.physics.time.SimultaneousImpacts;

/**
 * Queue of impacts with lower bounds of their times; a time is computed in double-double only when its entry is the
 * earliest. The earliest entry is refined and put back until the earliest one is refined already, so that no other can
 * be earlier. An entry whose refined time is not in the turn is dropped. Ties, to the last bit of a double-double, go
 * to the lowest pair, or in the order of the scan if the law has batches.
 */
final class RefiningQueue extends ImpactQueue {

    private final ExactPairs pairs;
    private final ExactWalls walls;
    private final ContactDistance distance;
    private final boolean batched;
    private final double window;
    private final DoubleDouble until = new DoubleDouble();
    private final DoubleDouble left = new DoubleDouble();
    private Bodies bodies;
    private DoubleDouble now;
    private double startHigh;
    private double startLow;

    /** Times from now: lower bounds, or refined times with their low parts. */
    private double[] high = new double[16];
    private double[] low = new double[16];
    private boolean[] refined = new boolean[16];
    private long[] rank = new long[16];
    private int[] firsts = new int[16];
    private int[] seconds = new int[16];
    private int size;

    RefiningQueue(ImpactLaw law, ExactPairs pairs, ExactWalls walls, Contacts contacts) {
        distance = contacts.hasReaches() ? new ContactDistance(contacts) : null;
        this.pairs = pairs;
        this.walls = walls;
        batched = law.batchWindow() > 0;
        window = law.batchWindow();
    }

    /** Begins a turn with these bodies; the flight keeps the time of the turn in the register. */
    void begin(Bodies ofTurn, DoubleDouble timeOfTurn) {
        bodies = ofTurn;
        now = timeOfTurn;
    }

    @Override
    void clear() {
        startHigh = now.high();
        startLow = now.low();
        left.setDifference(1, startHigh).add(-startLow);
        size = 0;
    }

    @Override
    void offer(double time, int a, int b) {
        if (size == high.length) {
            grow();
        }
        high[size] = time - startHigh - ExactPairs.ROUNDING;
        low[size] = 0;
        refined[size] = false;
        rank[size] = batched ? size : SimultaneousImpacts.rank(a, b);
        firsts[size] = a;
        seconds[size] = b;
        size++;
    }

    @Override
    int nextBatch() {
        int count = 0;
        while (count < size) {
            int k = earliest(count);
            if (count > 0 && high[k] - high[0] > window) {
                break;
            }
            if (refined[k]) {
                swap(k, count);
                count++;
                if (!batched) {
                    break;
                }
            } else {
                refine(k);
            }
        }
        return count;
    }

    private int earliest(int from) {
        int best = from;
        for (int k = from + 1; k < size; k++) {
            if (isBefore(k, best)) {
                best = k;
            }
        }
        return best;
    }

    /** An entry that is not refined yet comes before a refined one at the same time, to be refined. */
    private boolean isBefore(int k, int other) {
        if (high[k] != high[other]) {
            return high[k] < high[other];
        }
        if (refined[k] != refined[other]) {
            return refined[other];
        }
        return low[k] != low[other] ? low[k] < low[other] : rank[k] < rank[other];
    }

    private void refine(int k) {
        boolean happens = seconds[k] < 0 ? walls.exactTime(bodies, firsts[k], ~seconds[k], until)
            : exactTime(firsts[k], seconds[k]);
        if (!happens || until.compareTo(left) > 0) {
            size--;
            swap(k, size);
            return;
        }
        refined[k] = true;
        high[k] = until.high();
        low[k] = until.low();
    }

    private boolean exactTime(int a, int b) {
        boolean own = distance != null && distance.enter(bodies, a, b);
        boolean happens = pairs.exactTime(bodies, a, b, until);
        if (own) {
            distance.leave(bodies, a, b);
        }
        return happens;
    }

    /** The time from now to the k-th impact. */
    void until(int k, DoubleDouble result) {
        result.setFastSum(high[k], low[k]);
    }

    @Override
    double time(int k) {
        double sum = startHigh + high[k];
        return sum + (ErrorFree.sumError(startHigh, high[k], sum) + (startLow + low[k]));
    }

    @Override
    int a(int k) {
        return firsts[k];
    }

    @Override
    int b(int k) {
        return seconds[k];
    }

    private void swap(int i, int j) {
        if (i == j) {
            return;
        }
        double aDouble = high[i];
        high[i] = high[j];
        high[j] = aDouble;
        aDouble = low[i];
        low[i] = low[j];
        low[j] = aDouble;
        boolean aFlag = refined[i];
        refined[i] = refined[j];
        refined[j] = aFlag;
        long aLong = rank[i];
        rank[i] = rank[j];
        rank[j] = aLong;
        int index = firsts[i];
        firsts[i] = firsts[j];
        firsts[j] = index;
        index = seconds[i];
        seconds[i] = seconds[j];
        seconds[j] = index;
    }

    private void grow() {
        int room = 2 * size;
        high = Arrays.copyOf(high, room);
        low = Arrays.copyOf(low, room);
        refined = Arrays.copyOf(refined, room);
        rank = Arrays.copyOf(rank, room);
        firsts = Arrays.copyOf(firsts, room);
        seconds = Arrays.copyOf(seconds, room);
    }
}
