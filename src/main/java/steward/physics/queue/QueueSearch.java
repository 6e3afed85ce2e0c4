package steward.physics.queue;

import static steward.physics.queue.Crowd.CHANGES;
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
import steward.physics.time.TimeOfImpact;

/*
 * The filter of pairs. With d from one centre to the other and v its velocity, a = v.v, b = d.v, c = d.d - s^2, a pair
 * that approaches (b < 0) and does not touch (c > 0) meets, if b^2 > a c, after
 *
 *     t = c / (sqrt(b^2 - a c) - b),    which is at least c / -2b.
 *
 * So a pair is left out without a root or a division if b >= 0, or c >= -2b times what is left until the impact that
 * was known before, or b^2 < a c. Where the two are now is known but for a few units in the last place of their
 * coordinates x and of their ways since their last impacts, 2^-50 (|x| + |v|) for each; that moves c by at most 2 |d|
 * times as much, and 2 |d| e <= 2^-40 d.d + 2^40 e^2. So much (and more) is taken from c first: what is in doubt is
 * kept, and computed as the rung says, from the places where the last of the two changed its flight: a time of impact
 * depends on nothing but the two flights, whoever computes it and when.
 */

/**
 * Finds the next impact of a body, looking only at its neighbours. It knows its own next impact and nobody else's: of
 * two bodies, the one that looked last has seen the other, so that the earlier of their events is never later than
 * their impact. An impact that a neighbour cannot live to see (because it has an earlier one) is left to whoever looks
 * then.
 */
sealed class QueueSearch permits ExactQueueSearch {

    /** Products below have lost digits to underflow. */
    private static final double LEAST = 1e-250;
    /** A little below 1, for what roundings may add to a quotient. */
    private static final double BIT_LESS = 1 - 0x1p-40;

    final Crowd crowd;
    final EventBuckets events;
    private final CircleTime circles;
    private final Wall[] walls;
    private final HalfPlane[] planes;
    private final QueuePairs pairs;
    private int[] near = new int[16];
    double best;
    int partner;

    /** @param pairs which pairs meet at all, or {@code null} when all do */
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

    /** Room for so many neighbours. */
    void begin(int capacity) {
        if (near.length <= capacity) {
            near = new int[capacity + 1];
        }
    }

    /** The search of a body has ended; whoever computes more digits of times keeps those of the best now. */
    void found(int body) {
        // a double is all there is
    }

    /** The search of a body begins with the impact that it knows of. */
    void known(int body) {
        // a double is all there is
    }

    /** What its arrays take, in bytes. */
    long bytes() {
        return 4L * near.length;
    }

    /** A body looks at everything around it, and its next event goes into the queue. */
    void predict(int body, double now) {
        int at = 8 * body;
        crowd.link[at + CROSSED] = 0;
        best = NEVER;
        lookAt(body, crowd.isOutside(body) ? everybody() : neighbours(at), now);
        lookAtWalls(body, now);
        crowd.state[at + IMPACT] = best;
        found(body);
        if (best < NEVER) {
            crowd.link[at + PARTNER] = partner;
            crowd.link[at + PARTNER_CHANGES] = partner >= 0 ? crowd.link[8 * partner + CHANGES] : 0;
        }
        enqueue(body, now);
    }

    private int everybody() {
        for (int k = 0; k < crowd.size; k++) {
            near[k] = k;
        }
        return crowd.size;
    }

    private int neighbours(int at) {
        int found = crowd.cells.gatherAround(crowd.link[at + COLUMN], crowd.link[at + ROW], near);
        System.arraycopy(crowd.outside, 0, near, found, crowd.outsiders);
        return found + crowd.outsiders;
    }

    /** A body goes over into the next cell and looks at those that have become neighbours by it. */
    void cross(int body, double now) {
        double[] state = crowd.state;
        int[] link = crowd.link;
        int at = 8 * body;
        int column = link[at + COLUMN];
        int row = link[at + ROW];
        if (++link[at + CROSSED] > 64 + (crowd.size >> 3)) {
            crowd.leave(body);                         // it has cost as much as looking at everybody once
            predict(body, now);
            return;
        }
        Cells cells = crowd.cells;
        cells.remove(body, cells.at(column, row));
        int stepColumn = (link[at + EVENT] & 3) - 2;
        int stepRow = (link[at + EVENT] >> 2) - 2;
        column += stepColumn;
        row += stepRow;
        link[at + COLUMN] = column;
        link[at + ROW] = row;
        int found = cells.gatherSide(column + stepColumn, row + stepRow, stepRow, stepColumn, near);
        cells.add(body, cells.at(column, row));
        if (Math.abs(column) >= Cells.FAR || Math.abs(row) >= Cells.FAR) {
            crowd.leave(body);
            predict(body, now);
            return;
        }
        if (found > 0) {
            best = state[at + IMPACT];
            partner = link[at + PARTNER];
            known(body);
            double before = best;
            lookAt(body, found, now);
            if (best < before || best < NEVER && partner != link[at + PARTNER]) {
                state[at + IMPACT] = best;
                found(body);
                link[at + PARTNER] = partner;
                link[at + PARTNER_CHANGES] = crowd.link[8 * partner + CHANGES];
            }
        }
        enqueue(body, now);
    }

    private void lookAtWalls(int body, double now) {
        if (pairs != null && !pairs.meetsWalls(body)) {
            return;
        }
        double[] state = crowd.state;
        int at = 8 * body;
        double since = state[at + SINCE];
        for (int w = 0; w < walls.length; w++) {
            HalfPlane plane = planes[w];
            if (plane != null) {
                double closing = -(state[at + VX] * plane.insideX() + state[at + VY] * plane.insideY());
                double gap = plane.gap(state[at + X], state[at + Y], state[at + RADIUS]);
                if (gap * BIT_LESS > closing * (Math.min(best, 1) - since)) {
                    continue;                          // gap over closing is later; most walls are receded from
                }
            }
            if (pairs == null || pairs.meetsWall(body, w)) {
                offerWall(body, w, now);
            }
        }
    }

    /** Computes when a body meets a wall, and keeps it if that is earlier than the best so far. */
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
     * Looks for an earlier impact with the first so many that are near; itself among them does no harm. First the
     * filter goes through all of them, without a branch, then those that it has left meet the body.
     */
    private void lookAt(int body, int count, double now) {
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
            double b = dx * dvx + dy * dvy;
            double touch = radius + state[other + RADIUS];
            double squared = dx * dx + dy * dy;
            double c = squared - touch * touch - (0x1p-38 * squared + 0x1p-57 * a + doubt);
            double twice = b - Math.abs(b);            // 2b if they approach, otherwise 0
            double misses = 4 * (a * c) - twice * twice - LEAST;
            double late = c + twice * left;
            others[kept] = others[k];
            // All three below 0. What overflows, and is no number then, misses: not by the sign that a processor gives.
            kept += (int) ((Double.doubleToRawLongBits(b) & Double.doubleToLongBits(misses)
                & Double.doubleToRawLongBits(late)) >>> 63);
        }
        for (int k = 0; k < kept; k++) {
            if (pairs == null || pairs.meet(body, others[k])) {
                offer(body, others[k], now);
            }
        }
    }

    /** Computes when a pair meets, and keeps it if that is earlier than the best so far and than the other's next. */
    void offer(int body, int other, double now) {
        double[] state = crowd.state;
        int i = 8 * body;
        int j = 8 * other;
        double since = Math.max(state[i + SINCE], state[j + SINCE]);
        double flownI = since - state[i + SINCE];
        double flownJ = since - state[j + SINCE];
        double dx = state[i + X] + state[i + VX] * flownI - (state[j + X] + state[j + VX] * flownJ);
        double dy = state[i + Y] + state[i + VY] * flownI - (state[j + Y] + state[j + VY] * flownJ);
        double dvx = state[i + VX] - state[j + VX];
        double dvy = state[i + VY] - state[j + VY];
        if (!(dx * dvx + dy * dvy < 0)) {
            return;
        }
        double touch = state[i + RADIUS] + state[j + RADIUS];
        double until = Math.sqrt(dx * dx + dy * dy) <= touch ? 0
            : circles.untilApproachingMeet(dx, dy, dvx, dvy, touch);
        double time = Math.max(now, since + until);
        if (until <= 1 - since && time <= best && !(time > state[j + IMPACT])
            && (time < best || isLower(body, other))) {
            best = time;
            partner = other;
        }
    }

    /** At the same time: whether the other's index is lower than that of the partner so far; walls come last. */
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

    /** Until a body is so far from the middle, on the side to which it flies. */
    private static double timeToLeave(double fromMiddle, double v, double reach) {
        return v == 0 ? NEVER : (Math.copySign(reach, v) - fromMiddle) / v;
    }

    /** 1 or -1, as the sign of a velocity. */
    private static int step(double v) {
        return (int) (Double.doubleToRawLongBits(v) >> 63) | 1;
    }
}
