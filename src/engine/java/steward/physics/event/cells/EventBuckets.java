package steward.physics.event.cells;

import java.util.Arrays;

/*
 * A ring of buckets of equal width holds the events of the near future in unordered lists, an overflow list holds the
 * later events, and only the events of the present bucket are in a heap: about one per bucket, so that each operation
 * takes constant time on the average (G. Paul, "A Complexity O(1) priority queue for event driven molecular dynamics
 * simulations", 2007). The overflow list is redistributed once in a round of the ring: an event enters it only if it is
 * at least a whole round away. Where many events fall into one bucket, this is a plain heap of them. The width affects
 * only the speed, never the order.
 *
 * An entry whose body has left its list stays there until the list is taken apart: so an event is replaced without
 * reading the records of other bodies, which lie anywhere in memory. When all entries are used, lists are made anew.
 */

/**
 * Queue of the next event of each body, in the order of time. A body has at most one. Ties are broken by {@link Order}.
 * No event is earlier than the last one removed.
 */
final class EventBuckets {

    /** Decides between two bodies whose events are at the same time, as doubles. */
    interface Order {

        /** True if the event of body i comes before that of body j. */
        boolean isBefore(int i, int j);
    }

    /** The place of a body without an event. In the heap a place is at least 0, in list n it is {@code IN_LIST - n}. */
    private static final int ABSENT = -1;
    private static final int IN_LIST = -2;
    /** Buckets per body: the ring is this many mean gaps long, and few events are farther away. */
    private static final int PER_BODY = 3;
    private static final int LEAST_BUCKETS = 16;
    private static final int ENTRIES_PER_BODY = 2;
    /** With fewer or more events per bucket on the average, the width is chosen anew. */
    private static final double LEAST_FILL = 0.1;
    private static final double MOST_FILL = 3;
    private static final double NONE = Double.POSITIVE_INFINITY;
    private static final double MOST_SCALE = 0x1p60;

    private final Order order;
    /** The records of the bodies, of which {@link Crowd#PLACE} and {@link Crowd#TIME} are kept here. */
    private int[] links = new int[0];
    private double[] states = new double[0];
    /** Entries of lists, of two numbers each: a body, and the next entry or -1. */
    private int[] entries = new int[0];
    /** The first entry that is free again, or -1; and the number of entries that were ever used. */
    private int free;
    private int used;
    private int[] heads = new int[0];
    private int[] heap = new int[0];
    private int bodies;
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
     * @param links   see {@link Crowd#link}
     * @param states  see {@link Crowd#state}
     */
    void begin(int bodies, int capacity, double now, double meanGap, int[] links, double[] states) {
        this.links = links;
        this.states = states;
        if (heap.length < bodies) {
            entries = new int[2 * ENTRIES_PER_BODY * capacity];
            heap = new int[capacity];
        }
        buckets = LEAST_BUCKETS + PER_BODY * bodies;
        if (heads.length <= buckets) {
            heads = new int[LEAST_BUCKETS + PER_BODY * capacity + 1];
        }
        for (int body = 0; body < bodies; body++) {
            setPlace(body, ABSENT);
        }
        clearLists();
        this.bodies = bodies;
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
        return states[8 * body + Crowd.TIME];
    }

    private int place(int body) {
        return links[8 * body + Crowd.PLACE];
    }

    private void setPlace(int body, int place) {
        links[8 * body + Crowd.PLACE] = place;
    }

    /** Sets the event of a body, replacing the one it had. */
    void put(int body, double time) {
        remove(body);
        size++;
        states[8 * body + Crowd.TIME] = time;
        insert(body, time);
    }

    private void insert(int body, double time) {
        long ahead = (long) ((time - base) * scale) - current;
        if (ahead <= 0) {
            push(body);
        } else if (ahead < buckets) {
            int bucket = slot + (int) ahead;
            addTo(bucket < buckets ? bucket : bucket - buckets, body);
        } else {
            addTo(buckets, body);
        }
    }

    private void addTo(int list, int body) {
        int entry = free;
        if (entry >= 0) {
            free = entries[2 * entry + 1];
        } else {
            if (2 * used == entries.length) {
                insertAllAnew();
            }
            entry = used++;
        }
        entries[2 * entry] = body;
        entries[2 * entry + 1] = heads[list];
        heads[list] = entry;
        setPlace(body, IN_LIST - list);
    }

    /** Removes the event of a body, if it has one; an entry of a list stays there until its turn comes. */
    void remove(int body) {
        int from = place(body);
        if (from != ABSENT) {
            size--;
            setPlace(body, ABSENT);
            if (from >= 0) {
                removeFromHeap(from);
            }
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
                insertAnew(slot);
            }
            if (current == horizon) {
                redistributeOverflow();
            }
        }
        return heap[0];
    }

    /** Takes a list apart, and inserts the bodies still in it anew: those of the present bucket into the heap. */
    private void insertAnew(int list) {
        int entry = heads[list];
        heads[list] = -1;
        while (entry >= 0) {
            int body = entries[2 * entry];
            int after = entries[2 * entry + 1];
            entries[2 * entry + 1] = free;
            free = entry;
            if (place(body) == IN_LIST - list) {
                insert(body, time(body));
            }
            entry = after;
        }
    }

    /**
     * Moves events of the overflow list that are now near into the ring. If buckets have proved too wide or too narrow,
     * the width is changed and all events are inserted anew.
     */
    private void redistributeOverflow() {
        double fill = (double) eventsServed / bucketsPassed;
        double earliest = fill >= LEAST_FILL && fill <= MOST_FILL ? NONE : earliest();
        if (earliest < NONE) {
            base = earliest;
            scale = Math.min(scale * Math.min(16, Math.max(0.0625, fill)), MOST_SCALE);
            startRound(0);
            insertAllAnew();
        } else {
            startRound(current);
            insertAnew(buckets);
        }
    }

    private void insertAllAnew() {
        clearLists();
        for (int body = 0; body < bodies; body++) {
            if (place(body) <= IN_LIST) {
                insert(body, time(body));
            }
        }
    }

    private void clearLists() {
        Arrays.fill(heads, 0, buckets + 1, -1);
        free = -1;
        used = 0;
    }

    /** The time of the earliest event in a list. */
    private double earliest() {
        double earliest = NONE;
        for (int body = 0; body < bodies; body++) {
            earliest = place(body) <= IN_LIST ? Math.min(earliest, time(body)) : earliest;
        }
        return earliest;
    }

    private void startRound(long from) {
        current = from;
        eventsServed = 0;
        bucketsPassed = buckets;
        horizon = from + buckets;
    }

    /** The number of buckets that have been passed so far, in all turns. */
    long passed() {
        return passed;
    }

    /**
     * Collects the bodies of at most {@code most} entries of the next buckets, and returns how many they are. A body
     * whose event has moved within these buckets is there several times. No branch depends on what is read.
     *
     * @param into room for one more
     */
    int gatherNext(int nextBuckets, int[] into, int most) {
        int found = 0;
        int last = Math.min(nextBuckets, buckets - 1);
        for (int k = 1; k <= last && found < most; k++) {
            int bucket = slot + k;
            into[found] = heads[bucket < buckets ? bucket : bucket - buckets];
            found += 1 + (into[found] >> 31);
        }
        for (int k = 0; k < found && found < most; k++) {
            into[found] = entries[2 * into[k] + 1];
            found += 1 + (into[found] >> 31);
        }
        int staying = 0;
        for (int k = 0; k < found; k++) {
            into[staying] = entries[2 * into[k]];
            int list = IN_LIST - place(into[staying]);
            int ahead = list - slot;
            ahead += ahead >> 31 & buckets;
            staying += 1 + (last - ahead >> 31) & ~(list >> 31) & (list - buckets >> 31);
        }
        return staying;
    }

    private boolean isBefore(int i, int j) {
        return time(i) < time(j) || time(i) == time(j) && order.isBefore(i, j);
    }

    private void push(int body) {
        eventsServed++;
        rise(body, heapSize++);
    }

    private void rise(int body, int from) {
        int at = from;
        while (at > 0) {
            int parent = at - 1 >> 1;
            if (!isBefore(body, heap[parent])) {
                break;
            }
            heap[at] = heap[parent];
            setPlace(heap[at], at);
            at = parent;
        }
        heap[at] = body;
        setPlace(body, at);
    }

    private void removeFromHeap(int hole) {
        int last = heap[--heapSize];
        if (hole == heapSize) {
            return;
        }
        int at = hole;
        for (int child = 2 * at + 1; child < heapSize; child = 2 * at + 1) {
            if (child + 1 < heapSize && isBefore(heap[child + 1], heap[child])) {
                child++;
            }
            if (isBefore(last, heap[child])) {
                break;
            }
            heap[at] = heap[child];
            setPlace(heap[at], at);
            at = child;
        }
        if (at == hole) {
            rise(last, at);
        } else {
            heap[at] = last;
            setPlace(last, at);
        }
    }
}
