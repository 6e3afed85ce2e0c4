package steward.physics.queue;

import java.util.Arrays;

/*
 * A ring of buckets of equal width holds the events of the near future in unordered lists, an overflow list holds the
 * later events, and only the events of the present bucket are in a heap: about one per bucket, so that each operation
 * takes constant time on the average (G. Paul, "A Complexity O(1) priority queue for event driven molecular dynamics
 * simulations", 2007). The overflow list is redistributed once in a round of the ring: an event enters it only if it is
 * at least a whole round away. Where many events fall into one bucket, this is a plain heap of them. The width affects
 * only the speed, never the order.
 */

/**
 * The next event of each body, in the order of time. A body has at most one. Ties are broken by {@link Order}. No event
 * is earlier than the last one removed.
 */
final class EventBuckets {

    /** Decides between two bodies whose events are at the same time, as doubles. */
    interface Order {

        /** True if the event of body i comes before that of body j. */
        boolean isBefore(int i, int j);
    }

    private static final int ABSENT = Integer.MIN_VALUE;
    private static final int IN_HEAP = Integer.MIN_VALUE + 1;
    /** Buckets per body: the ring is this many mean gaps long, and few events are farther away. */
    private static final int PER_BODY = 3;
    private static final int LEAST_BUCKETS = 16;
    /** With fewer or more events per bucket on the average, the width is chosen anew. */
    private static final double LEAST_FILL = 0.1;
    private static final double MOST_FILL = 3;
    private static final double MOST_SCALE = 0x1p60;

    private final Order order;
    private double[] key = new double[0];
    /** The next body in the list, or the position in the heap. */
    private int[] next = new int[0];
    /** The previous body in the list, {@code ~bucket} for the first one, or {@link #ABSENT} or {@link #IN_HEAP}. */
    private int[] previous = new int[0];
    private int[] heads = new int[0];
    private int[] heap = new int[0];
    private int buckets;
    /** The number of events, in all and in the heap. */
    private int size;
    private int heapSize;
    /** The number of the present bucket, counted from {@link #base}, and its place in the ring. */
    private long current;
    private int slot;
    private long passed;
    /** The bucket number at which the overflow list is redistributed. */
    private long horizon;
    /** Since the last redistribution: events that entered the heap, and buckets passed. */
    private int eventsServed;
    private int bucketsPassed;
    private double base;
    private double scale;

    EventBuckets(Order order) {
        this.order = order;
    }

    /**
     * Clears the queue for a turn of {@code bodies} bodies.
     *
     * @param now     no event is earlier
     * @param meanGap estimated time from event to event of a body, above 0; affects only the speed
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
        startRound(0);
        bucketsPassed = buckets / 8;                   // soon, because the mean gap is only an estimate
        horizon = bucketsPassed;
    }

    /** The time of the event of a body; meaningless if it has none. */
    double time(int body) {
        return key[body];
    }

    /** Sets the event of a body, replacing the one it had. */
    void put(int body, double time) {
        if (previous[body] != ABSENT) {
            remove(body);
        }
        size++;
        key[body] = time;
        insert(body, time);
    }

    private void insert(int body, double time) {
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

    /** Removes the event of a body, if it has one. */
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

    /** The body whose event is next, or -1; the event stays in the queue. */
    int first() {
        while (heapSize == 0) {
            if (size == 0) {
                return -1;
            }
            current++;
            passed++;
            if (++slot == buckets) {
                slot = 0;
            }
            if (heads[slot] >= 0) {
                moveToHeap(slot);
            }
            if (current == horizon) {
                redistributeOverflow();
            }
        }
        return heap[0];
    }

    /** Moves a list into the heap. */
    private void moveToHeap(int bucket) {
        int body = heads[bucket];
        heads[bucket] = -1;
        while (body >= 0) {
            int after = next[body];
            push(body);
            body = after;
        }
    }

    /**
     * Moves events of the overflow list that are now near into the ring. If buckets have proved too wide or too narrow,
     * the width is changed and all events are inserted anew.
     */
    private void redistributeOverflow() {
        double fill = (double) eventsServed / bucketsPassed;
        int chain = heads[buckets];
        heads[buckets] = -1;
        boolean even = fill >= LEAST_FILL && fill <= MOST_FILL;
        for (int bucket = 0; bucket < buckets && !even; bucket++) {
            chain = prepend(heads[bucket], chain);
            heads[bucket] = -1;
        }
        if (even || chain < 0) {
            startRound(current);
        } else {
            base = earliest(chain);
            scale = Math.min(scale * Math.min(16, Math.max(0.0625, fill)), MOST_SCALE);
            startRound(0);
        }
        for (int body = chain; body >= 0;) {
            int after = next[body];
            insert(body, key[body]);
            body = after;
        }
    }

    private void startRound(long from) {
        current = from;
        eventsServed = 0;
        bucketsPassed = buckets;
        horizon = from + buckets;
    }

    private int prepend(int list, int chain) {
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

    /** The number of buckets that have been passed so far, in all turns. */
    long passed() {
        return passed;
    }

    /** Reads all that is stored of a body. @return a value that depends on it */
    double read(int body) {
        return key[body] + next[body] + previous[body];
    }

    /** Collects the bodies of at most {@code most} events in the next buckets, and returns how many they are. */
    int gatherNext(int nextBuckets, int[] into, int most) {
        int found = 0;
        for (int k = 1; k <= Math.min(nextBuckets, buckets - 1) && found < most; k++) {
            int bucket = slot + k;
            int head = heads[bucket < buckets ? bucket : bucket - buckets];
            into[found] = head;
            found += head < 0 ? 0 : 1;
        }
        for (int k = 0; k < found && found < most; k++) {
            int after = next[into[k]];
            into[found] = after;
            found += after < 0 ? 0 : 1;
        }
        return found;
    }

    private boolean isBefore(int i, int j) {
        return key[i] < key[j] || key[i] == key[j] && order.isBefore(i, j);
    }

    private void push(int body) {
        eventsServed++;
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

    /** The size of its arrays, in bytes. */
    long bytes() {
        return 8L * key.length + 4L * (next.length + previous.length + heads.length + heap.length);
    }
}
