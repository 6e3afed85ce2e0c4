package steward.physics.queue;

import static steward.physics.queue.Crowd.COLUMN;
import static steward.physics.queue.Crowd.EVENT;
import static steward.physics.queue.Crowd.PARTNER;
import static steward.physics.queue.Crowd.ROW;
import static steward.physics.queue.Crowd.X;

/**
 * A reader of the memory that the next events of a large crowd will need. Events that follow each other in time are
 * strangers in space, and each would wait for several lines of memory, one after the other. Here the lines of many
 * events are read in stages; within a stage no line depends on another, so that the processor waits for several at
 * once. Nothing is changed by it but the speed.
 */
final class LookAhead {

    /** The least number of bodies for which it pays: smaller crowds fit into the caches. */
    static final int LEAST_BODIES = 1 << 16;
    /** The wanted number of events at a time: what they need fits into a cache of the second level. */
    private static final int EVENTS = 270;
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
    private double read;

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
        double[] state = crowd.state;
        int[] link = crowd.link;
        int next = events.gatherNext(buckets, bodies, bodies.length / 2);
        buckets = Math.max(1, Math.min(EVENTS, buckets * EVENTS / Math.max(1, next)));
        int count = next;
        double sum = 0;
        for (int k = 0; k < next; k++) {
            int at = 8 * bodies[k];
            sum += state[at + X] + events.read(bodies[k]);
            bodies[count] = link[at + PARTNER];
            count += link[at + EVENT] == 0 && link[at + PARTNER] >= 0 ? 1 : 0;
        }
        for (int k = next; k < count; k++) {
            sum += state[8 * bodies[k] + X] + link[8 * bodies[k] + PARTNER] + events.read(bodies[k]);
        }
        int found = 0;
        for (int k = 0; k < count && found + 9 < near.length; k++) {
            int at = 8 * bodies[k];
            found = crowd.cells.appendHeads(link[at + COLUMN], link[at + ROW], near, found);
        }
        for (int k = 0; k < found && found < near.length; k++) {
            int following = crowd.cells.following(near[k]);
            near[found] = following;
            found += following < 0 ? 0 : 1;
        }
        for (int k = 0; k < found; k++) {
            sum += state[8 * near[k] + X];
        }
        read = sum;
    }

    /** The size of its arrays, in bytes. */
    long bytes() {
        return 4L * (bodies.length + near.length);
    }
}
