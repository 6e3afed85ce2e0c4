package steward.physics.event.cells;

import java.util.Arrays;
import steward.physics.Bodies;
import steward.physics.event.flight.PairSelection;
import steward.physics.time.PreciseFlight;
import steward.physics.time.SimultaneousImpacts;

/**
 * Bodies of a turn as {@link CellFlights} keeps them: the state of a body is that of the start of its present free
 * flight. Bodies are stored in the order of tiles of cells, so that neighbours are near each other in memory; the
 * classes of this package call the position in this order a body. The eight doubles of a body fill a cache line; they
 * are all that a search reads of a neighbour. They begin 64 bytes after an array does, whose header has 16: if arrays
 * begin with a line, as large ones do, no record lies in two.
 *
 * <p>As an order it breaks ties between events whose times are equal as doubles: first by the low parts; then cell
 * crossings come first, and of impacts the lowest pair, bodies before walls.
 */
final class Crowd implements EventBuckets.Order {

    /** Offsets in {@link #state}: the position at the start of the flight, in u. */
    static final int X = 6;
    static final int Y = 7;
    /** The velocity of the flight, in u per turn. */
    static final int VX = 8;
    static final int VY = 9;
    /** The local clock: the start of the flight, as a time of the turn. */
    static final int SINCE = 10;
    /** Its radius; where a contact begins at a distance of its own, at least half of the widest. */
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
    /** The index of each body in {@link Bodies}, its id and its mass: what only a reaction needs. */
    int[] index = new int[0];
    int[] id = new int[0];
    double[] mass = new double[0];
    /** The bodies that are in no cell: too large, too far away, or too fast for cells to pay. */
    int[] outside = new int[0];
    int outsideCount;
    int size;
    final Cells cells;
    final boolean exact;
    private final PreciseFlight flight = new PreciseFlight();
    /** Bodies that were loaded last. */
    Bodies bodies;
    /** {@code null} if all can react. */
    private final PairSelection selection;

    /**
     * @param exact whether times are double-doubles
     * @param slack see {@link Cells}
     */
    Crowd(boolean exact, double slack, PairSelection selection) {
        this.exact = exact;
        this.selection = selection;
        cells = new Cells(slack);
    }

    /** Loads the bodies at a time of the turn. */
    void load(Bodies of, double now, double nowLow) {
        bodies = of;
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
        if (size == 0) {
            return;
        }
        cells.begin(bodies, selection);
        cells.sort(bodies, index);
        for (int body = 0; body < size; body++) {
            int i = index[body];
            int at = 8 * body;
            id[body] = bodies.id(i);
            state[at + X] = bodies.x[i];
            state[at + Y] = bodies.y[i];
            state[at + VX] = bodies.vx[i];
            state[at + VY] = bodies.vy[i];
            state[at + SINCE] = now;
            state[at + RADIUS] = radius(selection, bodies, i);
            state[at + IMPACT] = NEVER;
            mass[body] = bodies.mass[i];
            cells.clearChanges(body);
            link[at + OUTSIDE] = -1;
            assignCell(body);
        }
    }

    /** The radius by which neighbours are looked for. */
    static double radius(PairSelection selection, Bodies bodies, int i) {
        return selection == null ? bodies.radius[i] : selection.widestRadius(bodies, i);
    }

    /** Writes the state of a body to {@link #bodies}. */
    void show(int body) {
        int to = index[body];
        int at = 8 * body;
        bodies.x[to] = state[at + X];
        bodies.y[to] = state[at + Y];
        bodies.vx[to] = state[at + VX];
        bodies.vy[to] = state[at + VY];
    }

    /** Writes the position at a time and the velocity of a body to {@link #bodies}, without ending its flight. */
    void store(int body, double now, double nowLow) {
        int to = index[body];
        int at = 8 * body;
        double x = state[at + X];
        double y = state[at + Y];
        double vx = state[at + VX];
        double vy = state[at + VY];
        bodies.vx[to] = vx;
        bodies.vy[to] = vy;
        if (!exact) {
            double time = now - state[at + SINCE];
            bodies.x[to] = x + vx * time;
            bodies.y[to] = y + vy * time;
            return;
        }
        double time = flight.elapsed(state[at + SINCE], low[4 * body + SINCE_LOW], now, nowLow);
        boolean whole = time == 1 && flight.elapsedLow == 0;       // no impact in this turn: one rounding, no -0.0
        bodies.x[to] = whole ? x + vx + 0.0 : flight.coordinate(x, vx, time);
        bodies.y[to] = whole ? y + vy + 0.0 : flight.coordinate(y, vy, time);
    }

    /** Starts a new flight of a body at its position at a time. */
    void fly(int body, double now, double nowLow) {
        int at = 8 * body;
        int to = 4 * body;
        double since = state[at + SINCE];
        state[at + SINCE] = now;
        cells.countChange(body);
        if (!exact) {
            state[at + X] += state[at + VX] * (now - since);
            state[at + Y] += state[at + VY] * (now - since);
            return;
        }
        double time = flight.elapsed(since, low[to + SINCE_LOW], now, nowLow);
        low[to + SINCE_LOW] = nowLow;
        state[at + X] = flight.coordinate(state[at + X], state[at + VX], time);
        low[to + X_LOW] = flight.placeLow;
        state[at + Y] = flight.coordinate(state[at + Y], state[at + VY], time);
        low[to + Y_LOW] = flight.placeLow;
    }

    double ownRadius(int body) {
        return selection == null ? state[8 * body + RADIUS] : bodies.radius[index[body]];
    }

    /** Replaces the state of a body by that of the i-th of others, and finds its cell anew if it has to. */
    void take(int body, Bodies from, int i) {
        int at = 8 * body;
        double radius = radius(selection, from, i);
        state[at + VX] = from.vx[i];
        state[at + VY] = from.vy[i];
        if (state[at + X] != from.x[i] || state[at + Y] != from.y[i] || state[at + RADIUS] != radius
            || isOutside(body)) {
            removeFromCell(body);
            state[at + X] = from.x[i];
            state[at + Y] = from.y[i];
            state[at + RADIUS] = radius;
            assignCell(body);
        }
    }

    /** The index of a body in {@link Bodies}; of a wall, {@code ~wall}, that itself. */
    int index(int body) {
        return body < 0 ? body : index[body];
    }

    /** The rank of an impact among those at one time. */
    long rank(int body, int partner) {
        return SimultaneousImpacts.rank(index[body], index(partner));
    }

    @Override
    public boolean isBefore(int i, int j) {
        double lowI = lowOfEvent(i);
        double lowJ = lowOfEvent(j);
        if (lowI != lowJ) {
            return lowI < lowJ;
        }
        long rankI = rankOfEvent(i);
        long rankJ = rankOfEvent(j);
        return rankI < rankJ || rankI == rankJ && index[i] < index[j];
    }

    /** The low part of the time of an impact; 0 for a cell crossing. */
    private double lowOfEvent(int body) {
        return !exact || link[8 * body + EVENT] != 0 ? 0 : low[4 * body + IMPACT_LOW];
    }

    private long rankOfEvent(int body) {
        return link[8 * body + EVENT] != 0 ? -1 : rank(body, link[8 * body + PARTNER]);
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

    /** An estimate of the time to the next event of a body: half of a cell's side at mean speed. */
    double meanGap() {
        double sum = 0;
        for (int at = 0; at < 8 * size; at += 8) {
            sum += Math.abs(state[at + VX]) + Math.abs(state[at + VY]);
        }
        return cells.side() / 2 / (sum / size);
    }
}
