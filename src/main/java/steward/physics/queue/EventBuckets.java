package steward.physics.queue;

import java.util.Arrays;

/*
 * A ring of buckets of equal width holds the events of the near future in unordered lists, one list holds the rest, and
 * only the events of the present bucket stand in a heap: about one per bucket, so that each operation takes constant
 * time on the average (G. Paul, "A Complexity O(1) priority queue for event driven molecular dynamics simulations",
 * 2007). The rest is looked through once in a round of the ring: whatever it holds was too far away then, by a whole
 * round. Where many events fall into one bucket it is a heap of them all. The width only decides how long it takes,
 * never the order.
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
    /** How many buckets there are for each body: so many mean gaps long is the ring, and few events wait longer. */
    private static final int PER_BODY = 3;
    private static final int LEAST_BUCKETS = 16;
    /** With fewer or more events in a bucket, on the average, the width is chosen anew. */
    private static final double LEAST_FILL = 0.1;
    private static final double MOST_FILL = 3;
    private static final double MOST_SCALE = 0x1p60;

    private final Order order;
    private double[] key = new double[0];
    /** The next in the list, or the place in the heap. */
    private int[] next = new int[0];
    /** The one before in the list, {@code ~bucket} of the first one, or one of the two above. */
    private int[] previous = new int[0];
    private int[] heads = new int[0];
    private int[] heap = new int[0];
    private int buckets;
    /** How many events there are, in all and in the heap. */
    private int size;
    private int heapSize;
    /** The number of the present bucket, counted from {@link #base}, and its place in the ring. */
    private long current;
    private int slot;
    /** Where the rest is looked through again. */
    private long horizon;
    /** How many events have come into the heap since it was, and from how many buckets. */
    private int served;
    private int passed;
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
        buckets = LEAST_BUCKETS + PER_BODY * bodies;
        if (heads.length <= buckets) {
            heads = new int[LEAST_BUCKETS + PER_BODY * capacity + 1];
        }
        Arrays.fill(heads, 0, buckets + 1, -1);
        Arrays.fill(previous, 0, bodies, ABSENT);
        size = 0;
        heapSize = 0;
        slot = 0;
        base = now;
        scale = meanGap > 0 ? Math.min(bodies / meanGap, MOST_SCALE) : MOST_SCALE;
        openRound(0);
        passed = buckets / 8;                          // soon: what the mean gap is worth has to be seen
        horizon = passed;
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
        size++;
        key[body] = time;
        enter(body, time);
    }

    private void enter(int body, double time) {
        long ahead = (long) ((time - base) * scale) - current;
        if (ahead <= 0) {
            push(body);
        } else if (ahead < buckets) {
            int bucket = slot + (int) ahead;
            link(body, bucket < buckets ? bucket : bucket - buckets);
        } else {
            link(body, buckets);
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
        size--;
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
            if (size == 0) {
                return -1;
            }
            current++;
            if (++slot == buckets) {
                slot = 0;
            }
            if (heads[slot] >= 0) {
                empty(slot);
            }
            if (current == horizon) {
                lookThroughRest();
            }
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

    /** What has come near goes into the ring. If buckets have proved too wide or too narrow, all others move too. */
    private void lookThroughRest() {
        double fill = (double) served / passed;
        int chain = heads[buckets];
        heads[buckets] = -1;
        boolean even = fill >= LEAST_FILL && fill <= MOST_FILL;
        for (int bucket = 0; bucket < buckets && !even; bucket++) {
            chain = join(heads[bucket], chain);
            heads[bucket] = -1;
        }
        if (even || chain < 0) {
            openRound(current);
        } else {
            base = earliest(chain);
            scale = Math.min(scale * Math.min(16, Math.max(0.0625, fill)), MOST_SCALE);
            openRound(0);
        }
        for (int body = chain; body >= 0;) {
            int after = next[body];
            enter(body, key[body]);
            body = after;
        }
    }

    private void openRound(long from) {
        current = from;
        served = 0;
        passed = buckets;
        horizon = from + buckets;
    }

    private int join(int list, int chain) {
        int joined = chain;
        for (int body = list; body >= 0;) {
            int after = next[body];
            next[body] = joined;
            joined = body;
            body = after;
        }
        return joined;
    }

    private double earliest(int chain) {
        double earliest = Double.POSITIVE_INFINITY;
        for (int body = chain; body >= 0; body = next[body]) {
            earliest = Math.min(earliest, key[body]);
        }
        return earliest;
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
