package steward.physics;

import java.util.Arrays;

/*
 * Buckets of equal width hold the events of the near future in unordered lists, one list holds the rest, and only the
 * events of the present bucket stand in a heap: about one per bucket, so that each operation takes constant time on
 * the average (G. Paul, "A Complexity O(1) priority queue for event driven molecular dynamics simulations", 2007).
 * Where many events fall into one bucket it is a heap of them all. The width only decides how long it takes, never the
 * order.
 */

/**
 * The next event of each body, in the order of time. A body has at most one. Ties are broken by {@link Order}.
 * Times never lie before that of the last event taken out.
 */
final class EventBuckets {

    /** Decides between two bodies whose events are at the same time, as doubles. */
    interface Order {

        /** Whether the event of body i comes before that of body j. */
        boolean isBefore(int i, int j);
    }

    private static final int ABSENT = Integer.MIN_VALUE;
    private static final int IN_HEAP = Integer.MIN_VALUE + 1;

    private final Order order;
    private double[] key = new double[0];
    /** The next in the list, or the place in the heap. */
    private int[] next = new int[0];
    /** The one before in the list, {@code ~bucket} of the first one, or one of the two above. */
    private int[] previous = new int[0];
    private int[] heads = new int[0];
    private int[] heap = new int[0];
    private int buckets;
    private int heapSize;
    private int current;
    private int served;
    private double base;
    private double scale;

    EventBuckets(Order order) {
        this.order = order;
    }

    /**
     * Becomes empty, for a turn of so many bodies.
     *
     * @param now     no event comes before
     * @param meanGap about how long a body waits for its event, above 0; it only decides how long it takes
     */
    void begin(int bodies, int capacity, double now, double meanGap) {
        if (key.length < bodies) {
            key = new double[capacity];
            next = new int[capacity];
            previous = new int[capacity];
            heap = new int[capacity];
        }
        buckets = Math.max(64, Integer.highestOneBit(Math.max(1, bodies - 1)) << 1);
        if (heads.length <= buckets) {
            heads = new int[buckets + 1];
        }
        Arrays.fill(heads, 0, buckets + 1, -1);
        Arrays.fill(previous, 0, bodies, ABSENT);
        heapSize = 0;
        current = 0;
        served = buckets;
        base = now;
        scale = meanGap > 0 ? Math.min(bodies / meanGap, 0x1p60) : 0x1p60;
    }

    /** When the event of a body is; meaningless if it has none. */
    double time(int body) {
        return key[body];
    }

    /** A body has an event at this time and no other. */
    void put(int body, double time) {
        if (previous[body] != ABSENT) {
            remove(body);
        }
        key[body] = time;
        enter(body, time);
    }

    private void enter(int body, double time) {
        double bucket = (time - base) * scale;
        if (bucket < current + 1) {
            push(body);
        } else {
            link(body, bucket < buckets ? (int) bucket : buckets);
        }
    }

    private void link(int body, int bucket) {
        int head = heads[bucket];
        next[body] = head;
        previous[body] = ~bucket;
        if (head >= 0) {
            previous[head] = body;
        }
        heads[bucket] = body;
    }

    /** A body has no event any more. */
    void remove(int body) {
        int before = previous[body];
        if (before == ABSENT) {
            return;
        }
        previous[body] = ABSENT;
        int after = next[body];
        if (before == IN_HEAP) {
            removeFromHeap(after);
            return;
        }
        if (before >= 0) {
            next[before] = after;
        } else {
            heads[~before] = after;
        }
        if (after >= 0) {
            previous[after] = before;
        }
    }

    /** The body whose event is next, or -1; it stays. */
    int first() {
        while (heapSize == 0) {
            if (++current >= buckets && !openNextWindow()) {
                return -1;
            }
            empty(current);
        }
        return heap[0];
    }

    /** Moves a list into the heap. */
    private void empty(int bucket) {
        int body = heads[bucket];
        heads[bucket] = -1;
        while (body >= 0) {
            int after = next[body];
            push(body);
            body = after;
        }
    }

    /** All buckets are behind: spreads the rest over them anew, as wide as it took. @return false if there is none */
    private boolean openNextWindow() {
        int body = heads[buckets];
        if (body < 0) {
            current = buckets;
            return false;
        }
        double earliest = Double.POSITIVE_INFINITY;
        for (int b = body; b >= 0; b = next[b]) {
            earliest = Math.min(earliest, key[b]);
        }
        double fill = (double) served / buckets;
        scale = Math.min(scale * Math.min(16, Math.max(0.0625, fill)), 0x1p60);
        base = earliest;
        served = 0;
        current = 0;
        heads[buckets] = -1;
        while (body >= 0) {
            int after = next[body];
            enter(body, key[body]);
            body = after;
        }
        return true;
    }

    private boolean isBefore(int i, int j) {
        return key[i] < key[j] || key[i] == key[j] && order.isBefore(i, j);
    }

    private void push(int body) {
        served++;
        previous[body] = IN_HEAP;
        rise(body, heapSize++);
    }

    private void rise(int body, int from) {
        int place = from;
        while (place > 0) {
            int parent = place - 1 >> 1;
            if (!isBefore(body, heap[parent])) {
                break;
            }
            heap[place] = heap[parent];
            next[heap[place]] = place;
            place = parent;
        }
        heap[place] = body;
        next[body] = place;
    }

    private void removeFromHeap(int hole) {
        int last = heap[--heapSize];
        if (hole == heapSize) {
            return;
        }
        int place = hole;
        for (int child = 2 * place + 1; child < heapSize; child = 2 * place + 1) {
            if (child + 1 < heapSize && isBefore(heap[child + 1], heap[child])) {
                child++;
            }
            if (isBefore(last, heap[child])) {
                break;
            }
            heap[place] = heap[child];
            next[heap[place]] = place;
            place = child;
        }
        if (place == hole) {
            rise(last, place);
        } else {
            heap[place] = last;
            next[last] = place;
        }
    }

    /** What its arrays take, in bytes. */
    long bytes() {
        return 8L * key.length + 4L * (next.length + previous.length + heads.length + heap.length);
    }
}
