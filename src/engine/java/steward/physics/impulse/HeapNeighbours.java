package steward.physics.impulse;

import java.util.Arrays;
import steward.physics.Bodies;

/**
 * Bodies near another one, found by cells: for the heaps of {@link Rest}, whose bodies stay where they are while the
 * heap is solved. A cell is as wide as the largest body that is not much larger than the others; the few that are count
 * as near to everything.
 */
final class HeapNeighbours {

    /** Fewer bodies are all neighbours. */
    private static final int FEWEST = 32;
    /** Bodies of more than this many mean radii are in no cell. */
    private static final double LARGE = 4;
    /** Bound on the numbers of cells: beyond it, all share one. */
    private static final double MOST_CELLS = 1L << 40;

    /** The neighbours that were found last, ascending. */
    int[] found = new int[0];
    private int size;
    private boolean inCells;
    private double width;
    /** Head of a bucket of cells, and of a body the next one in its bucket; -1 for none. */
    private int[] head = new int[0];
    private int[] next = new int[0];
    private long[] cellX = new long[0];
    private long[] cellY = new long[0];
    private int[] large = new int[0];
    private int largeCount;

    /** Begins with the bodies where they are. */
    void begin(Bodies bodies) {
        size = bodies.size();
        inCells = size >= FEWEST;
        if (found.length < size) {
            int capacity = bodies.capacity();
            found = new int[capacity];
            next = new int[capacity];
            cellX = new long[capacity];
            cellY = new long[capacity];
            large = new int[capacity];
            head = new int[Integer.highestOneBit(capacity) * 4];
        }
        if (inCells) {
            fill(bodies);
        }
    }

    private void fill(Bodies bodies) {
        double sum = 0;
        for (int i = 0; i < size; i++) {
            sum += bodies.radius[i];
        }
        double most = LARGE * sum / size;
        width = 0;
        largeCount = 0;
        for (int i = 0; i < size; i++) {
            if (bodies.radius[i] > most) {
                large[largeCount++] = i;
            } else {
                width = Math.max(width, 2 * bodies.radius[i]);
            }
        }
        Arrays.fill(head, -1);
        for (int i = 0; i < size; i++) {
            if (bodies.radius[i] <= most) {
                cellX[i] = cell(bodies.x[i]);
                cellY[i] = cell(bodies.y[i]);
                int bucket = bucket(cellX[i], cellY[i]);
                next[i] = head[bucket];
                head[bucket] = i;
            }
        }
    }

    private long cell(double x) {
        return (long) Math.floor(Math.max(-MOST_CELLS, Math.min(MOST_CELLS, x / width)));
    }

    private int bucket(long x, long y) {
        long mixed = (x * 0x9E3779B97F4A7C15L + y) * 0xBF58476D1CE4E5B9L;
        return (int) (mixed >>> 40) & head.length - 1;
    }

    /**
     * Finds all bodies whose gap to a body may be at most a share of the sum of both radii, and some more, the body
     * itself too.
     *
     * @param more a gap that counts in any case
     * @return how many are in {@link #found}
     */
    int find(Bodies bodies, int i, double gapShare, double more) {
        double reach = 1.01 * ((bodies.radius[i] + width / 2) * (1 + gapShare) + more);
        long left = 0;
        long right = 0;
        long low = 0;
        long high = 0;
        boolean all = !inCells;
        if (inCells) {
            left = cell(bodies.x[i] - reach);
            right = cell(bodies.x[i] + reach);
            low = cell(bodies.y[i] - reach);
            high = cell(bodies.y[i] + reach);
            all = (double) (right - left + 1) * (high - low + 1) > size;
        }
        if (all) {
            for (int j = 0; j < size; j++) {
                found[j] = j;
            }
            return size;
        }
        int count = 0;
        for (int k = 0; k < largeCount; k++) {
            count = insert(large[k], count);
        }
        for (long x = left; x <= right; x++) {
            for (long y = low; y <= high; y++) {
                for (int j = head[bucket(x, y)]; j >= 0; j = next[j]) {
                    if (cellX[j] == x && cellY[j] == y) {
                        count = insert(j, count);
                    }
                }
            }
        }
        return count;
    }

    private int insert(int j, int count) {
        int place = count;
        for (; place > 0 && found[place - 1] > j; place--) {
            found[place] = found[place - 1];
        }
        found[place] = j;
        return count + 1;
    }
}
