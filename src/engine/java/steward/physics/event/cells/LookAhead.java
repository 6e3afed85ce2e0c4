package steward.physics.event.cells;

import static steward.physics.event.cells.Crowd.COLUMN;
import static steward.physics.event.cells.Crowd.EVENT;
import static steward.physics.event.cells.Crowd.PARTNER;
import static steward.physics.event.cells.Crowd.ROW;
import static steward.physics.event.cells.Crowd.X;

/**
 * Prefetch of the memory that the next events of a large crowd will need. Events that follow each other in time are far
 * apart in space, and each would wait for several lines of memory, one after the other. Here the lines of many events
 * are read in stages; within a stage no line depends on another, so that the processor waits for several at once; and
 * no branch depends on a line that has yet to come. It changes nothing but the speed.
 */
final class LookAhead {

    /** The wanted number of events at a time: what they need leaves room in a cache of the second level. */
    private static final int EVENTS = 70;
    /** The greatest number of cells where one event searches. */
    private static final int MOST_HEADS = 18;
    /** Buckets that are read at first, before it is known how full they are. */
    private static final int FIRST_BUCKETS = 16;

    private final Crowd crowd;
    private final EventBuckets events;
    private final int leastBodies;
    /** The bodies of the next events, then the partners of their impacts. */
    private int[] bodies = new int[0];
    /** The bodies in the cells around these, some of them several times. */
    private int[] near = new int[0];
    /** Number of buckets that are read at a time. */
    private int buckets;
    /** The number of passed buckets at which the next are read. */
    private long until;
    /** A value that depends on all that was read: otherwise a compiler may leave the reading out. */
    private long read;

    /** @param leastBodies from how many bodies on it reads */
    LookAhead(Crowd crowd, EventBuckets events, int leastBodies) {
        this.crowd = crowd;
        this.events = events;
        this.leastBodies = leastBodies;
    }

    /** Begins anew, after all events have been put into the queue. */
    void begin() {
        boolean reads = crowd.size >= leastBodies;
        until = reads ? 0 : Long.MAX_VALUE;
        buckets = FIRST_BUCKETS;
        if (reads && bodies.length == 0) {
            bodies = new int[4 * EVENTS];
            near = new int[64 * EVENTS];
        }
    }

    /** Reads ahead if all that was read before has been used. */
    void read() {
        if (events.passed() >= until) {
            until = events.passed() + buckets;
            readAhead();
        }
    }

    private void readAhead() {
        int count = events.gatherNext(buckets, bodies, bodies.length / 2);
        buckets = Math.max(1, Math.min(EVENTS, buckets * EVENTS / Math.max(1, count)));
        long sum = readBodies(count);
        int found = 0;
        for (int k = 0; k < count && found + MOST_HEADS < near.length; k++) {
            found = appendHeads(bodies[k], found);
        }
        for (int k = 0; k < found && found < near.length; k++) {
            near[found] = crowd.cells.following(near[k]);
            found += 1 + (near[found] >> 31);
        }
        for (int k = 0; k < found; k++) {
            sum += state(near[k]);
        }
        read = sum;
    }

    /** Reads the records of the bodies that have events and, after these, of those that they meet. */
    private long readBodies(int count) {
        int[] link = crowd.link;
        long sum = 0;
        int all = count;
        for (int k = 0; k < count; k++) {
            int body = bodies[k];
            int impact = link[8 * body + EVENT] - 1 >> 31;         // -1 for an impact, 0 for a crossing
            bodies[all] = link[8 * body + PARTNER];
            all += 1 + (bodies[all] >> 31) & impact;
            sum += state(body) + reaction(body & impact);
        }
        for (int k = count; k < all; k++) {
            int body = bodies[k];
            sum += state(body) + reaction(body) + link[8 * body + PARTNER];
        }
        return sum;
    }

    /** Reads what only a reaction needs. */
    private long reaction(int body) {
        return Double.doubleToRawLongBits(crowd.mass[body]) + crowd.index[body] + crowd.id[body];
    }

    /** Appends the first bodies of the cells where an event searches, and returns how many there are then. */
    private int appendHeads(int body, int before) {
        int[] link = crowd.link;
        int at = 8 * body;
        int column = link[at + COLUMN];
        int row = link[at + ROW];
        int event = link[at + EVENT];
        if (event != 0) {
            int stepColumn = Crowd.columnStep(event);
            int stepRow = Crowd.rowStep(event);
            near[before] = crowd.cells.first(column, row);
            int found = before + 1 + (near[before] >> 31);
            return crowd.cells.appendSideHeads(column + 2 * stepColumn, row + 2 * stepRow, stepRow, stepColumn, near,
                found);
        }
        int found = crowd.cells.appendHeads(column, row, near, before);
        int partner = 8 * link[at + PARTNER];
        return partner < 0 || link[partner + COLUMN] == column && link[partner + ROW] == row ? found
            : crowd.cells.appendHeads(link[partner + COLUMN], link[partner + ROW], near, found);
    }

    private long state(int body) {
        return Double.doubleToRawLongBits(crowd.state[8 * body + X]);
    }
}
