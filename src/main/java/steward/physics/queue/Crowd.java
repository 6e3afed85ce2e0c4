package steward.physics.queue;

import java.util.Arrays;
import steward.numerics.ErrorFree;
import steward.physics.Bodies;
import steward.physics.time.LowParts;

/**
 * The bodies of a turn as {@link QueueAdvance} keeps them, each with a clock of its own: where it was when it last
 * changed its flight. They stand in the order of their cells, so that neighbours are near each other in memory; a
 * body's place in this order is what the classes around this one call a body. Eight doubles a body, as a cache line
 * holds, are what a search reads of a neighbour and a reaction of the two that meet.
 */
final class Crowd {

    /** Places in {@link #state}: where a body was, in u. */
    static final int X = 0;
    static final int Y = 1;
    /** Its velocity since, in u per turn. */
    static final int VX = 2;
    static final int VY = 3;
    /** When that was, as a time of the turn. */
    static final int SINCE = 4;
    static final int RADIUS = 5;
    /** When it has its next impact as far as it knows; infinite for none in this turn. */
    static final int IMPACT = 6;
    static final int MASS = 7;

    /** Places in {@link #link}: how often the flight of a body has changed. */
    static final int CHANGES = 0;
    /** With whom it has its next impact: a body, or {@code ~wall}. */
    static final int PARTNER = 1;
    /** How often that one's flight had changed when this was foreseen. */
    static final int PARTNER_CHANGES = 2;
    /** Its cell; kept by counting the crossings, not from its coordinates. */
    static final int COLUMN = 3;
    static final int ROW = 4;
    /** How many cells it has crossed since it last looked around. */
    static final int CROSSED = 5;
    /** Its event: an impact (0), or leaving its cell as far as it may, by 2 + step of column + 4 (2 + step of row). */
    static final int EVENT = 6;
    /** Its place among those that are in no cell, or -1. */
    static final int OUTSIDE = 7;

    /** Places in {@link #low}: what {@link #SINCE} and {@link #IMPACT} lack as doubles. */
    static final int SINCE_LOW = 0;
    static final int IMPACT_LOW = 1;
    /** What the coordinates lack, as long as nobody has moved the body since. */
    static final int X_LOW = 2;
    static final int Y_LOW = 3;

    static final double NEVER = Double.POSITIVE_INFINITY;

    /** Eight a body. */
    double[] state = new double[0];
    /** Eight a body. */
    int[] link = new int[0];
    /** Four a body where times are double-doubles, otherwise none. */
    double[] low = new double[0];
    /** What the present time lacks as a double. */
    double nowLow;
    /** Their indices in {@link Bodies}. */
    int[] index = new int[0];
    /** Those that are in no cell: too large, too far away, or too fast for it to pay. */
    int[] outside = new int[0];
    int outsiders;
    int size;
    final Cells cells = new Cells();
    private final boolean exact;
    /** What {@link #flown} and {@link #place} have left out of their results. */
    private double flownLow;
    private double placeLow;

    /** @param exact whether times are double-doubles, and places are rounded once, when they are stored */
    Crowd(boolean exact) {
        this.exact = exact;
    }

    /** Takes over the bodies at the time {@code now} of the turn. */
    void load(Bodies bodies, double now) {
        size = bodies.size();
        if (index.length < size) {
            int capacity = bodies.capacity();
            state = new double[8 * capacity];
            link = new int[8 * capacity];
            index = new int[capacity];
            outside = new int[capacity];
            low = new double[exact ? 4 * capacity : 0];
        }
        Arrays.fill(low, 0, exact ? 4 * size : 0, 0);
        for (int body = 0; body < size && exact; body++) {
            low[4 * body + SINCE_LOW] = nowLow;
        }
        outsiders = 0;
        cells.begin(bodies);
        cells.sort(bodies, index);
        for (int body = 0; body < size; body++) {
            int of = index[body];
            int at = 8 * body;
            state[at + X] = bodies.x[of];
            state[at + Y] = bodies.y[of];
            state[at + VX] = bodies.vx[of];
            state[at + VY] = bodies.vy[of];
            state[at + SINCE] = now;
            state[at + RADIUS] = bodies.radius[of];
            state[at + IMPACT] = NEVER;
            state[at + MASS] = bodies.mass[of];
            link[at + CHANGES] = 0;
            link[at + OUTSIDE] = -1;
            settle(body);
        }
    }

    /** Puts a body that is in no list into the cell where its place says, or outside if it does not belong there. */
    void settle(int body) {
        int at = 8 * body;
        link[at + COLUMN] = cells.column(state[at + X]);
        link[at + ROW] = cells.row(state[at + Y]);
        link[at + CROSSED] = 0;
        if (link[at + COLUMN] == Cells.FAR || link[at + ROW] == Cells.FAR || !cells.holds(state[at + RADIUS])) {
            link[at + OUTSIDE] = outsiders;
            outside[outsiders++] = body;
        } else {
            cells.add(body, cells.at(link[at + COLUMN], link[at + ROW]));
        }
    }

    boolean isOutside(int body) {
        return link[8 * body + OUTSIDE] >= 0;
    }

    /** Takes a body out of its cell, or from outside. */
    void unsettle(int body) {
        int at = 8 * body;
        int place = link[at + OUTSIDE];
        if (place < 0) {
            cells.remove(body, cells.at(link[at + COLUMN], link[at + ROW]));
            return;
        }
        link[at + OUTSIDE] = -1;
        int last = outside[--outsiders];
        if (last != body) {
            outside[place] = last;
            link[8 * last + OUTSIDE] = place;
        }
    }

    /** Takes a body out of its cell for as long as it flies straight. */
    void leave(int body) {
        unsettle(body);
        link[8 * body + OUTSIDE] = outsiders;
        outside[outsiders++] = body;
    }

    /** The present is when a body has its impact. */
    void setNow(int body) {
        nowLow = exact ? low[4 * body + IMPACT_LOW] : 0;
    }

    /** A body begins a new flight where it is at a time. */
    void fly(int body, double now) {
        int at = 8 * body;
        double time = flown(body, now);
        state[at + SINCE] = now;
        if (!exact) {
            state[at + X] += state[at + VX] * time;
            state[at + Y] += state[at + VY] * time;
            return;
        }
        int to = 4 * body;
        low[to + SINCE_LOW] = nowLow;
        state[at + X] = place(state[at + X], state[at + VX], time);
        low[to + X_LOW] = placeLow;
        state[at + Y] = place(state[at + Y], state[at + VY], time);
        low[to + Y_LOW] = placeLow;
    }

    /**
     * Two fly to the present, which is their impact. Where places are rounded once, their time of impact was computed
     * from where both were when the second of them changed its flight ({@link ExactQueueSearch}); so the other flies
     * there first: then they touch now, to the last digit of the double-doubles.
     */
    void meet(int body, int partner, double now) {
        if (exact) {
            double ahead = ahead(body, partner);
            if (ahead != 0) {
                double kept = nowLow;
                int later = ahead > 0 ? body : partner;
                nowLow = low[4 * later + SINCE_LOW];
                fly(ahead > 0 ? partner : body, state[8 * later + SINCE]);
                nowLow = kept;
            }
        }
        fly(body, now);
        fly(partner, now);
    }

    /** By how much later than that of j the flight of i has changed; exact in its sign, and 0 at the same time. */
    double ahead(int i, int j) {
        double difference = state[8 * i + SINCE] - state[8 * j + SINCE];
        return difference != 0 ? difference : low[4 * i + SINCE_LOW] - low[4 * j + SINCE_LOW];
    }

    /** Says what the stored place of a body, which has just flown there, lacks. */
    void tell(int body, LowParts rounded, int i) {
        rounded.set(i, low[4 * body + X_LOW], low[4 * body + Y_LOW]);
    }

    /** How long a body has been on its flight at a time; ask before its {@link #place}. */
    double flown(int body, double now) {
        double since = state[8 * body + SINCE];
        double time = now - since;
        if (!exact) {
            return time;
        }
        double sinceLow = low[4 * body + SINCE_LOW];
        double rest = ErrorFree.sumError(now, -since, time);
        double sum = time + nowLow;
        rest += ErrorFree.sumError(time, nowLow, sum);
        time = sum + rest;
        rest = ErrorFree.fastSumError(sum, rest, time);
        sum = time - sinceLow;
        rest += ErrorFree.sumError(time, -sinceLow, sum);
        time = sum + rest;
        flownLow = ErrorFree.fastSumError(sum, rest, time);
        return time;
    }

    /** A coordinate after a time that {@link #flown} has just told, rounded once; for times in double-double only. */
    double place(double from, double v, double time) {
        double product = v * time;
        double lowProduct = v * flownLow;
        double path = product + lowProduct;
        double rest = ErrorFree.fastSumError(product, lowProduct, path) + ErrorFree.productError(v, time, product);
        double whole = path + rest;
        double sum = whole + from;
        rest = ErrorFree.fastSumError(path, rest, whole) + ErrorFree.sumError(whole, from, sum);
        double place = sum + rest;
        placeLow = ErrorFree.fastSumError(sum, rest, place);
        return place;
    }

    /** Writes down where everybody is at a time, and how fast. */
    void store(Bodies bodies, double now) {
        for (int body = 0; body < size; body++) {
            store(body, bodies, now);
        }
    }

    /** The same for one. */
    void store(int body, Bodies bodies, double now) {
        int to = index[body];
        int at = 8 * body;
        double time = flown(body, now);
        double vx = state[at + VX];
        double vy = state[at + VY];
        if (!exact) {
            bodies.x[to] = state[at + X] + vx * time;
            bodies.y[to] = state[at + Y] + vy * time;
        } else if (time == 1 && flownLow == 0) {       // no impact in this turn: one rounding, and no -0.0 as below
            bodies.x[to] = state[at + X] + vx + 0.0;
            bodies.y[to] = state[at + Y] + vy + 0.0;
        } else {
            bodies.x[to] = place(state[at + X], vx, time);
            bodies.y[to] = place(state[at + Y], vy, time);
        }
        bodies.vx[to] = vx;
        bodies.vy[to] = vy;
    }

    /** About how long a body takes to its next event: half of the way through a cell. */
    double meanGap() {
        double sum = 0;
        for (int at = 0; at < 8 * size; at += 8) {
            sum += Math.abs(state[at + VX]) + Math.abs(state[at + VY]);
        }
        return cells.side() / 2 / (sum / size);
    }

    /** What its arrays take, in bytes. */
    long bytes() {
        return 8L * (state.length + low.length) + 4L * (link.length + index.length + outside.length) + cells.bytes();
    }
}
