package steward.physics.queue;

import java.util.Arrays;
import steward.physics.Bodies;
import steward.physics.time.LowParts;
import steward.physics.time.PreciseFlight;

/**
 * The bodies of a turn as {@link QueueAdvance} keeps them, each with a local clock: the state of a body is that of the
 * start of its present free flight. Bodies are stored in the order of tiles of cells, so that neighbours are near each
 * other in memory; the classes of this package call the position in this order a body. The eight doubles of a body fill
 * a cache line; they are all that a search reads of a neighbour. They begin 64 bytes after an array does, whose header
 * has 16: where arrays begin with a line, as large ones do, no record lies in two.
 */
final class Crowd {

    /** Offsets in {@link #state}: the position at the start of the flight, in u. */
    static final int X = 6;
    static final int Y = 7;
    /** The velocity of the flight, in u per turn. */
    static final int VX = 8;
    static final int VY = 9;
    /** The local clock: the start of the flight, as a time of the turn. */
    static final int SINCE = 10;
    static final int RADIUS = 11;
    /** The time of its predicted next impact; infinite for none in this turn. */
    static final int IMPACT = 12;
    /** The time of its event, kept by {@link EventBuckets}. */
    static final int TIME = 13;

    /** Offsets in {@link #link}: its place in the queue, kept by {@link EventBuckets}. */
    static final int PLACE = 4;
    /** The partner of its predicted impact: a body, or {@code ~wall}. */
    static final int PARTNER = 5;
    /** How often the partner's flight had changed at the prediction. */
    static final int PARTNER_CHANGES = 6;
    /** Its cell; kept by counting the crossings, not from its coordinates. */
    static final int COLUMN = 7;
    static final int ROW = 8;
    /** Cell crossings since its last full search. */
    static final int CROSSED = 9;
    /** Its event: an impact (0), or a cell crossing, as 2 + step of column + 4 (2 + step of row). */
    static final int EVENT = 10;
    /** Its index in {@link #outside}, or -1. */
    static final int OUTSIDE = 11;

    /** Offsets in {@link #low}: the low parts of {@link #SINCE} and {@link #IMPACT}. */
    static final int SINCE_LOW = 0;
    static final int IMPACT_LOW = 1;
    /** The low parts of the coordinates, valid until the body is moved. */
    static final int X_LOW = 2;
    static final int Y_LOW = 3;

    static final double NEVER = Double.POSITIVE_INFINITY;

    /** Eight entries per body, after {@code X} that are not used. */
    double[] state = new double[0];
    /** Eight entries per body, after {@code PLACE} that are not used. */
    int[] link = new int[0];
    /** Four entries per body where times are double-doubles, otherwise none. */
    double[] low = new double[0];
    /** The low part of the present time. */
    double nowLow;
    /** The index of each body in {@link Bodies}, its id and its mass: what only a reaction needs. */
    int[] index = new int[0];
    int[] id = new int[0];
    double[] mass = new double[0];
    /** The bodies that are in no cell: too large, too far away, or too fast for cells to pay. */
    int[] outside = new int[0];
    int outsideCount;
    int size;
    final Cells cells;
    private final boolean exact;
    private final PreciseFlight flight = new PreciseFlight();

    /**
     * @param exact whether times are double-doubles, and positions are rounded once, when they are stored
     * @param slack see {@link Cells}
     */
    Crowd(boolean exact, double slack) {
        this.exact = exact;
        cells = new Cells(slack);
    }

    /** Loads the bodies at the time {@code now} of the turn. */
    void load(Bodies bodies, double now) {
        size = bodies.size();
        if (index.length < size) {
            int capacity = bodies.capacity();
            state = new double[8 * capacity + X];
            link = new int[8 * capacity + PLACE];
            index = new int[capacity];
            id = new int[capacity];
            mass = new double[capacity];
            outside = new int[capacity];
            low = new double[exact ? 4 * capacity : 0];
        }
        Arrays.fill(low, 0, exact ? 4 * size : 0, 0);
        for (int body = 0; body < size && exact; body++) {
            low[4 * body + SINCE_LOW] = nowLow;
        }
        outsideCount = 0;
        cells.begin(bodies);
        cells.sort(bodies, index);
        for (int body = 0; body < size; body++) {
            int of = index[body];
            int at = 8 * body;
            id[body] = bodies.id(of);
            state[at + X] = bodies.x[of];
            state[at + Y] = bodies.y[of];
            state[at + VX] = bodies.vx[of];
            state[at + VY] = bodies.vy[of];
            state[at + SINCE] = now;
            state[at + RADIUS] = bodies.radius[of];
            state[at + IMPACT] = NEVER;
            mass[body] = bodies.mass[of];
            cells.clearChanges(body);
            link[at + OUTSIDE] = -1;
            assignCell(body);
        }
    }

    /** The step to another column, or 0, of a crossing as {@link #EVENT} has it. */
    static int columnStep(int crossing) {
        return (crossing & 3) - 2;
    }

    static int rowStep(int crossing) {
        return (crossing >> 2) - 2;
    }

    /** Puts a body that is in no list into the cell of its position, or outside if it does not fit into cells. */
    void assignCell(int body) {
        int at = 8 * body;
        link[at + COLUMN] = cells.column(state[at + X]);
        link[at + ROW] = cells.row(state[at + Y]);
        link[at + CROSSED] = 0;
        if (link[at + COLUMN] == Cells.FAR || link[at + ROW] == Cells.FAR || !cells.holds(state[at + RADIUS])) {
            link[at + OUTSIDE] = outsideCount;
            outside[outsideCount++] = body;
        } else {
            cells.add(body, cells.cellAt(link[at + COLUMN], link[at + ROW]));
        }
    }

    boolean isOutside(int body) {
        return link[8 * body + OUTSIDE] >= 0;
    }

    /** Removes a body from its cell, or from outside. */
    void removeFromCell(int body) {
        int at = 8 * body;
        int place = link[at + OUTSIDE];
        if (place < 0) {
            cells.remove(body, cells.cellAt(link[at + COLUMN], link[at + ROW]));
            return;
        }
        link[at + OUTSIDE] = -1;
        int last = outside[--outsideCount];
        if (last != body) {
            outside[place] = last;
            link[8 * last + OUTSIDE] = place;
        }
    }

    /** Moves a body from its cell to outside until its flight changes. */
    void moveOutside(int body) {
        removeFromCell(body);
        link[8 * body + OUTSIDE] = outsideCount;
        outside[outsideCount++] = body;
    }

    /** Sets the present time to the predicted impact of a body. */
    void setNow(int body) {
        nowLow = exact ? low[4 * body + IMPACT_LOW] : 0;
    }

    /** Starts a new flight of a body at its position at a time. */
    void flyTo(int body, double now) {
        int at = 8 * body;
        double time = elapsed(body, now);
        state[at + SINCE] = now;
        if (!exact) {
            state[at + X] += state[at + VX] * time;
            state[at + Y] += state[at + VY] * time;
            return;
        }
        int to = 4 * body;
        low[to + SINCE_LOW] = nowLow;
        state[at + X] = coordinateAfter(state[at + X], state[at + VX], time);
        low[to + X_LOW] = flight.placeLow;
        state[at + Y] = coordinateAfter(state[at + Y], state[at + VY], time);
        low[to + Y_LOW] = flight.placeLow;
    }

    /**
     * Moves a pair to the present time, which is that of its impact. Where positions are rounded once, the time of
     * impact was computed from the positions at the later start of the two flights ({@link ExactQueueSearch}); so the
     * other body is moved to that time first: then the two touch now, to the last digit of the double-doubles.
     */
    void flyToContact(int body, int partner, double now) {
        if (exact) {
            double ahead = clockDifference(body, partner);
            if (ahead != 0) {
                double kept = nowLow;
                int later = ahead > 0 ? body : partner;
                nowLow = low[4 * later + SINCE_LOW];
                flyTo(ahead > 0 ? partner : body, state[8 * later + SINCE]);
                nowLow = kept;
            }
        }
        flyTo(body, now);
        flyTo(partner, now);
    }

    /** The start of the flight of i minus that of j; its sign is exact. */
    double clockDifference(int i, int j) {
        double difference = state[8 * i + SINCE] - state[8 * j + SINCE];
        return difference != 0 ? difference : low[4 * i + SINCE_LOW] - low[4 * j + SINCE_LOW];
    }

    /** Copies the low parts of the position of a body that has just been moved there. */
    void copyLowParts(int body, LowParts rounded, int i) {
        rounded.set(i, low[4 * body + X_LOW], low[4 * body + Y_LOW]);
    }

    /** The time since the start of a body's flight; call before {@link #coordinateAfter}. */
    double elapsed(int body, double now) {
        double since = state[8 * body + SINCE];
        if (!exact) {
            return now - since;
        }
        return flight.elapsed(since, low[4 * body + SINCE_LOW], now, nowLow);
    }

    /** A coordinate after the last result of {@link #elapsed}, rounded once; only where times are double-doubles. */
    double coordinateAfter(double from, double v, double time) {
        return flight.coordinate(from, v, time);
    }

    /** Writes the positions at a time and the velocities of all bodies to {@code bodies}. */
    void store(Bodies bodies, double now) {
        for (int body = 0; body < size; body++) {
            store(body, bodies, now);
        }
    }

    /** Writes the position at a time and the velocity of one body to {@code bodies}. */
    void store(int body, Bodies bodies, double now) {
        int to = index[body];
        int at = 8 * body;
        double time = elapsed(body, now);
        double vx = state[at + VX];
        double vy = state[at + VY];
        if (!exact) {
            bodies.x[to] = state[at + X] + vx * time;
            bodies.y[to] = state[at + Y] + vy * time;
        } else if (time == 1 && flight.elapsedLow == 0) { // no impact in this turn: one rounding, no -0.0 as below
            bodies.x[to] = state[at + X] + vx + 0.0;
            bodies.y[to] = state[at + Y] + vy + 0.0;
        } else {
            bodies.x[to] = coordinateAfter(state[at + X], vx, time);
            bodies.y[to] = coordinateAfter(state[at + Y], vy, time);
        }
        bodies.vx[to] = vx;
        bodies.vy[to] = vy;
    }

    void storeVelocities(Bodies bodies) {
        for (int body = 0; body < size; body++) {
            bodies.vx[index[body]] = state[8 * body + VX];
            bodies.vy[index[body]] = state[8 * body + VY];
        }
    }

    /** Moves a body to a time and takes its velocity. */
    void stop(int body, double now) {
        flyTo(body, now);
        state[8 * body + VX] = 0;
        state[8 * body + VY] = 0;
    }

    /** The position at the start of the flight, in u. */
    double x(int body) {
        return state[8 * body + X];
    }

    /** The position at the start of the flight, in u. */
    double y(int body) {
        return state[8 * body + Y];
    }

    /** An estimate of the time to the next event of a body: half of a cell's side at mean speed. */
    double meanGap() {
        double sum = 0;
        for (int at = 0; at < 8 * size; at += 8) {
            sum += Math.abs(state[at + VX]) + Math.abs(state[at + VY]);
        }
        return cells.side() / 2 / (sum / size);
    }

    long bytes() {
        return 8L * (state.length + low.length + mass.length)
            + 4L * (link.length + index.length + id.length + outside.length) + cells.bytes();
    }
}
