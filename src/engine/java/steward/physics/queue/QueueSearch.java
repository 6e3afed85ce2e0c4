package steward.physics.queue;

import static steward.physics.queue.Crowd.COLUMN;
import static steward.physics.queue.Crowd.CROSSED;
import static steward.physics.queue.Crowd.EVENT;
import static steward.physics.queue.Crowd.IMPACT;
import static steward.physics.queue.Crowd.NEVER;
import static steward.physics.queue.Crowd.PARTNER;
import static steward.physics.queue.Crowd.PARTNER_CHANGES;
import static steward.physics.queue.Crowd.RADIUS;
import static steward.physics.queue.Crowd.ROW;
import static steward.physics.queue.Crowd.SINCE;
import static steward.physics.queue.Crowd.VX;
import static steward.physics.queue.Crowd.VY;
import static steward.physics.queue.Crowd.X;
import static steward.physics.queue.Crowd.Y;

import steward.physics.Arithmetic;
import steward.physics.HalfPlane;
import steward.physics.Wall;
import steward.physics.time.CircleTime;
import steward.physics.time.SimultaneousImpacts;
import steward.physics.time.TimeOfImpact;

/*
 * The filter of pairs. With d from one centre to the other and v its velocity, a = v.v, b = d.v, c = d.d - s^2, a pair
 * that approaches (b < 0) and does not touch (c > 0) meets, if b^2 > a c, after
 *
 *     t = c / (sqrt(b^2 - a c) - b),    which is at least c / -2b.
 *
 * So a pair is left out without a root or a division if b >= 0, or c >= -2b times what is left until the impact that
 * was known before, or b^2 < a c. The present positions are accurate to a few units in the last place of the
 * coordinates x and of the paths since the last impacts, e = 2^-50 (|x| + |v|) for each; that moves c by at most 2 |d|
 * times as much, and 2 |d| e <= 2^-40 d.d + 2^40 e^2. It moves b by at most 3 e sqrt a <= 2^-41 a + 2^43 e^2, and
 * rounding b by 2^-51 |d| sqrt a <= 2^-52 (d.d + a): bodies that have just exchanged impulses at one instant can
 * approach by no more than that. At least this much is subtracted from c and b first, so pairs in doubt are kept. For
 * these the time is computed in the arithmetic of the rung, from the positions at the later start of the two flights: a
 * time of impact depends on nothing but the two flights, not on the body that searches nor on the time of the search.
 */

/**
 * Predicts the next impact of a body among its neighbours. A prediction is stored only with the body that searched: of
 * two bodies, the one that searched last has tested the other, so that the earlier of their events is never later than
 * their impact. An impact after an earlier one of the neighbour is not stored; it is found again by the searches after
 * that impact.
 */
sealed class QueueSearch permits ExactQueueSearch {

    /** Products below this have lost digits to underflow. */
    private static final double LEAST = 1e-250;
    /** Sums of a few terms, and places after a flight, are off by less than this share of their terms. */
    private static final double ROUNDING = 0x1p-46;
    /** A factor for the rounding error of a quotient. */
    private static final double JUST_BELOW_ONE = 1 - 0x1p-40;

    final Crowd crowd;
    final EventBuckets events;
    private final CircleTime circles;
    private final Wall[] walls;
    private final HalfPlane[] planes;
    private final QueuePairs pairs;
    private int[] near = new int[16];
    double best;
    int partner;

    /** @param pairs selects the pairs that can react, or {@code null} if all can */
    QueueSearch(Crowd crowd, EventBuckets events, Arithmetic arithmetic, Wall[] walls, QueuePairs pairs) {
        this.crowd = crowd;
        this.events = events;
        circles = CircleTime.of(arithmetic);
        this.walls = walls;
        this.pairs = pairs;
        planes = new HalfPlane[walls.length];
        for (int w = 0; w < walls.length; w++) {
            planes[w] = walls[w] instanceof HalfPlane plane ? plane : null;
        }
    }

    /** Makes room for {@code capacity} neighbours. */
    void begin(int capacity) {
        if (near.length <= capacity) {
            near = new int[capacity + 1];
        }
    }

    /** Hook at the end of a search: stores what belongs to the prediction besides the double. */
    void storePrediction(int body) {
        // here a prediction is a double and no more
    }

    /** Hook at the start of a search from an existing prediction: loads what {@link #storePrediction} has stored. */
    void loadPrediction(int body) {
        // here a prediction is a double and no more
    }

    long bytes() {
        return 4L * near.length;
    }

    /** Predicts the next impact of a body from a full search and puts its next event into the queue. */
    void predict(int body, double now) {
        int at = 8 * body;
        crowd.link[at + CROSSED] = 0;
        best = NEVER;
        testAll(body, now);
        crowd.state[at + IMPACT] = best;
        storePrediction(body);
        if (best < NEVER) {
            crowd.link[at + PARTNER] = partner;
            crowd.link[at + PARTNER_CHANGES] = partner >= 0 ? crowd.cells.changes(partner) : 0;
        }
        enqueue(body, now);
    }

    final void testAll(int body, double now) {
        testPairs(body, crowd.isOutside(body) ? allBodies() : neighbours(8 * body), now);
        testWalls(body, now);
    }

    /**
     * True if another impact may be at the same time as that of a body and its partner, by other means than the order
     * of times; then {@link #collect} has to decide.
     */
    boolean mayBeSimultaneous(int body, double now) {
        return false;
    }

    /** Decides the impacts at the time of the earliest one, from all near it of these bodies. */
    SimultaneousImpacts collect(int[] bodies, int count, double now) {
        throw new IllegalStateException("times of doubles are in their order");
    }

    /** True if the partners of an impact approach; both have been moved to it. */
    boolean areApproaching(int a, int b) {
        return true;
    }

    private int allBodies() {
        for (int k = 0; k < crowd.size; k++) {
            near[k] = k;
        }
        return crowd.size;
    }

    private int neighbours(int at) {
        int found = crowd.cells.gatherAround(crowd.link[at + COLUMN], crowd.link[at + ROW], near);
        System.arraycopy(crowd.outside, 0, near, found, crowd.outsideCount);
        return found + crowd.outsideCount;
    }

    /** Moves a body to the next cell and tests it with its new neighbours. */
    void cross(int body, double now) {
        double[] state = crowd.state;
        int[] link = crowd.link;
        int at = 8 * body;
        int column = link[at + COLUMN];
        int row = link[at + ROW];
        if (++link[at + CROSSED] > 64 + (crowd.size >> 3)) {
            crowd.moveOutside(body);                   // its crossings have cost as much as a test of all bodies
            predict(body, now);
            return;
        }
        Cells cells = crowd.cells;
        cells.remove(body, cells.cellAt(column, row));
        int stepColumn = Crowd.columnStep(link[at + EVENT]);
        int stepRow = Crowd.rowStep(link[at + EVENT]);
        column += stepColumn;
        row += stepRow;
        link[at + COLUMN] = column;
        link[at + ROW] = row;
        int found = cells.gatherSide(column + stepColumn, row + stepRow, stepRow, stepColumn, near);
        cells.add(body, cells.cellAt(column, row));
        if (Math.abs(column) >= Cells.FAR || Math.abs(row) >= Cells.FAR) {
            crowd.moveOutside(body);
            predict(body, now);
            return;
        }
        if (found > 0) {
            best = state[at + IMPACT];
            partner = link[at + PARTNER];
            loadPrediction(body);
            double before = best;
            testPairs(body, found, now);
            if (best < before || best < NEVER && partner != link[at + PARTNER]) {
                state[at + IMPACT] = best;
                storePrediction(body);
                link[at + PARTNER] = partner;
                link[at + PARTNER_CHANGES] = crowd.cells.changes(partner);
            }
        }
        enqueue(body, now);
    }

    /**
     * True if a body is within a small gap of another one or a wall besides its partner: a superset, for a quick
     * look.
     */
    boolean hasNear(int body, int of, double gapShare, double now) {
        double[] state = crowd.state;
        int at = 8 * body;
        double x = state[at + X];
        double y = state[at + Y];
        double radius = state[at + RADIUS];
        int count = crowd.isOutside(body) ? allBodies() : neighbours(at);
        for (int k = 0; k < count; k++) {
            int other = 8 * near[k];
            double time = now - state[other + SINCE];
            double dx = state[other + X] + state[other + VX] * time - x;
            double dy = state[other + Y] + state[other + VY] * time - y;
            double reach = (radius + state[other + RADIUS]) * (1 + gapShare);
            if (near[k] != body && near[k] != of && dx * dx + dy * dy <= reach * reach) {
                return true;
            }
        }
        for (int w = 0; w < walls.length; w++) {
            if (of != ~w && walls[w].gap(x, y, radius) <= gapShare * radius) {
                return true;
            }
        }
        return false;
    }

    private void testWalls(int body, double now) {
        if (pairs != null && !pairs.canReactWithWalls(body)) {
            return;
        }
        double[] state = crowd.state;
        int at = 8 * body;
        double since = state[at + SINCE];
        double speed = Math.abs(state[at + VX]) + Math.abs(state[at + VY]);
        double size = Math.abs(state[at + X]) + Math.abs(state[at + Y]) + state[at + RADIUS] + speed;
        for (int w = 0; w < walls.length; w++) {
            HalfPlane plane = planes[w];
            if (plane != null) {
                double closing = ROUNDING * speed
                    - (state[at + VX] * plane.insideX() + state[at + VY] * plane.insideY());
                double gap = plane.gap(state[at + X], state[at + Y], state[at + RADIUS])
                    - ROUNDING * (size + Math.abs(plane.x()) + Math.abs(plane.y()));
                if (gap * JUST_BELOW_ONE > closing * (Math.min(best, 1) - since)) {
                    continue;                          // later than the best; most walls are receded from
                }
            }
            if (pairs == null || pairs.canReactWithWall(body, w)) {
                offerWall(body, w, now);
            }
        }
    }

    /** Computes the time of impact with a wall, and keeps it if it is earlier than the best so far. */
    void offerWall(int body, int w, double now) {
        double[] state = crowd.state;
        int at = 8 * body;
        double since = state[at + SINCE];
        double until = TimeOfImpact.wall(walls[w], state[at + X], state[at + Y], state[at + VX],
            state[at + VY], state[at + RADIUS]);
        if (until <= 1 - since && Math.max(now, since + until) < best) {
            best = Math.max(now, since + until);
            partner = ~w;
        }
    }

    /**
     * Searches for an earlier impact with the first {@code count} entries of {@code near}, which may include the body
     * itself. First the filter passes over all of them without a branch, then times of impact are computed for those
     * that it has kept.
     */
    private void testPairs(int body, int count, double now) {
        double[] state = crowd.state;
        int[] others = near;
        int at = 8 * body;
        double time = now - state[at + SINCE];
        double vx = state[at + VX];
        double vy = state[at + VY];
        double x = state[at + X] + vx * time;
        double y = state[at + Y] + vy * time;
        double radius = state[at + RADIUS];
        double reach = Math.abs(x) + Math.abs(y) + Math.abs(vx) + Math.abs(vy);
        double doubt = 0x1p-57 * reach * reach;
        double left = Math.min(best, 1) - now;
        int kept = 0;
        for (int k = 0; k < count; k++) {
            int other = 8 * others[k];
            double dvx = vx - state[other + VX];
            double dvy = vy - state[other + VY];
            double of = now - state[other + SINCE];
            double dx = x - (state[other + X] + state[other + VX] * of);
            double dy = y - (state[other + Y] + state[other + VY] * of);
            double a = dvx * dvx + dvy * dvy;
            double squared = dx * dx + dy * dy;
            double b = dx * dvx + dy * dvy - (0x1p-46 * squared + 0x1p-40 * a + doubt);
            double touch = radius + state[other + RADIUS];
            double c = squared - touch * touch - (0x1p-38 * squared + 0x1p-57 * a + doubt);
            double twice = b - Math.abs(b);            // 2b if they approach, otherwise 0
            double misses = 4 * (a * c) - twice * twice - LEAST;
            double late = c + twice * left;
            others[kept] = others[k];
            // All three below 0. NaN after an overflow counts as a miss, whatever sign the processor gives it.
            kept += (int) ((Double.doubleToRawLongBits(b) & Double.doubleToLongBits(misses)
                & Double.doubleToRawLongBits(late)) >>> 63);
        }
        for (int k = 0; k < kept; k++) {
            if (pairs == null || pairs.canReact(body, others[k])) {
                offer(body, others[k], now);
            }
        }
    }

    /**
     * Computes the time of impact of a pair, and keeps it if it is earlier than the best so far and not later than the
     * other's predicted impact.
     */
    void offer(int body, int other, double now) {
        double[] state = crowd.state;
        int i = 8 * body;
        int j = 8 * other;
        double since = Math.max(state[i + SINCE], state[j + SINCE]);
        double flownI = since - state[i + SINCE];
        double flownJ = since - state[j + SINCE];
        double vxi = state[i + VX];
        double vyi = state[i + VY];
        double vxj = state[j + VX];
        double vyj = state[j + VY];
        double until = circles.untilInTurn(state[i + X] + vxi * flownI, state[j + X] + vxj * flownJ,
            state[i + Y] + vyi * flownI, state[j + Y] + vyj * flownJ, vxi, vxj, vyi, vyj, state[i + RADIUS],
            state[j + RADIUS], since);
        double time = Math.max(now, since + until);
        if (until < NEVER && time <= best && !(time > state[j + IMPACT])
            && (time < best || isLower(body, other))) {
            best = time;
            partner = other;
        }
    }

    /**
     * For equal times: whether the pair with the other body is lower than that with the partner so far; walls come
     * last.
     */
    boolean isLower(int body, int other) {
        return partner < 0 || EventOrder.rank(crowd, body, other) < EventOrder.rank(crowd, body, partner);
    }

    private void enqueue(int body, double now) {
        double[] state = crowd.state;
        int[] link = crowd.link;
        int at = 8 * body;
        double time = state[at + IMPACT];
        int event = 0;
        if (link[at + Crowd.OUTSIDE] < 0) {
            double vx = state[at + VX];
            double vy = state[at + VY];
            double reach = crowd.cells.reach();
            double x = timeToLeave(state[at + X] - crowd.cells.middleX(link[at + COLUMN]), vx, reach);
            double y = timeToLeave(state[at + Y] - crowd.cells.middleY(link[at + ROW]), vy, reach);
            double leaves = state[at + SINCE] + Math.min(x, y);
            if (leaves < time) {
                time = Math.max(now, leaves);
                event = x <= y ? step(vx) + 2 + (2 << 2) : 2 + (step(vy) + 2 << 2);
            }
        }
        if (time <= 1) {
            link[at + EVENT] = event;
            events.put(body, time);
        } else {
            events.remove(body);
        }
    }

    /** The time until a body is {@code reach} from the middle of its cell, on the side to which it flies. */
    private static double timeToLeave(double fromMiddle, double v, double reach) {
        return v == 0 ? NEVER : (Math.copySign(reach, v) - fromMiddle) / v;
    }

    /** 1 or -1, as the sign of a velocity. */
    private static int step(double v) {
        return (int) (Double.doubleToRawLongBits(v) >> 63) | 1;
    }
}
