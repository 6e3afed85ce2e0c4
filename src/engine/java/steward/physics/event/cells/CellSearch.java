package steward.physics.event.cells;

import static steward.physics.event.cells.Crowd.COLUMN;
import static steward.physics.event.cells.Crowd.CROSSED;
import static steward.physics.event.cells.Crowd.EVENT;
import static steward.physics.event.cells.Crowd.IMPACT;
import static steward.physics.event.cells.Crowd.IMPACT_LOW;
import static steward.physics.event.cells.Crowd.PARTNER;
import static steward.physics.event.cells.Crowd.PARTNER_CHANGES;
import static steward.physics.event.cells.Crowd.RADIUS;
import static steward.physics.event.cells.Crowd.ROW;
import static steward.physics.event.cells.Crowd.SINCE;
import static steward.physics.event.cells.Crowd.SINCE_LOW;
import static steward.physics.event.cells.Crowd.VX;
import static steward.physics.event.cells.Crowd.VY;
import static steward.physics.event.cells.Crowd.X;
import static steward.physics.event.cells.Crowd.Y;

import steward.physics.Bodies;
import steward.physics.PhysicsParts;
import steward.physics.event.flight.ImpactSearch;
import steward.physics.event.flight.PairSelection;
import steward.physics.time.PreciseFlight;
import steward.physics.time.SimultaneousImpacts;

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
 * Search for the next impact of a body among its neighbours in adjacent cells. A prediction is stored only with the
 * body that searched: of two bodies, the one that searched last has tested the other, so that the earlier of their
 * events is never later than their impact. An impact after an earlier one of the neighbour is not stored; the searches
 * after that impact find it again.
 */
final class CellSearch extends ImpactSearch {

    /** Products below this have lost digits to underflow. */
    private static final double LEAST = 1e-250;

    private final Crowd crowd;
    private final EventBuckets events;
    private final PreciseFlight flight = new PreciseFlight();
    private int[] near = new int[16];
    /** Where times are double-doubles, of each body: whether another impact of it is near its prediction in time. */
    private boolean[] doubtful = new boolean[0];

    CellSearch(PhysicsParts parts, Crowd crowd, EventBuckets events) {
        super(parts);
        this.crowd = crowd;
        this.events = events;
    }

    /** Makes room for {@code capacity} neighbours. */
    void begin(int capacity) {
        if (near.length <= capacity) {
            near = new int[capacity + 1];
        }
        if (crowd.exact && doubtful.length < capacity) {
            doubtful = new boolean[capacity];
        }
    }

    /** Predicts the next impact of a body from a full search and puts its next event into the queue. */
    void predict(int body, double now) {
        int at = 8 * body;
        crowd.link[at + CROSSED] = 0;
        clear();
        testAll(body, now);
        keep(body);
        if (crowd.exact) {
            doubtful[body] = bestDoubtful;
        }
        enqueue(body, now);
    }

    private void keep(int body) {
        int at = 8 * body;
        crowd.state[at + IMPACT] = best;
        if (best < NEVER) {
            crowd.link[at + PARTNER] = bestPartner;
            crowd.link[at + PARTNER_CHANGES] = bestPartner >= 0 ? crowd.cells.changes(bestPartner) : 0;
        }
        if (crowd.exact) {
            crowd.low[4 * body + IMPACT_LOW] = bestLow;
        }
    }

    private void testAll(int body, double now) {
        testPairs(body, crowd.isOutside(body) ? allBodies() : neighbours(8 * body), now);
        testWalls(body, now);
    }

    /** True if another impact of a body is near its prediction in time; only where times are double-doubles. */
    boolean isDoubtful(int body) {
        return doubtful[body];
    }

    /** Decides the impacts at the time of the earliest one, from all near it of these bodies. */
    SimultaneousImpacts collect(int[] bodies, int count, double now) {
        together.clear();
        collects = true;
        for (int k = 0; k < count; k++) {
            best = now + SimultaneousImpacts.NEAR;
            testAll(bodies[k], now);
        }
        collects = false;
        together.decide();
        return together;
    }

    @Override
    protected long rank(int body, int partner) {
        return crowd.rank(body, partner);
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
            bestPartner = link[at + PARTNER];
            if (crowd.exact) {
                bestLow = crowd.low[4 * body + IMPACT_LOW];
                bestDoubtful = doubtful[body];
            }
            double before = best;
            testPairs(body, found, now);
            if (best < before || best < NEVER && bestPartner != link[at + PARTNER]) {
                keep(body);
            }
            if (crowd.exact) {
                doubtful[body] = bestDoubtful;
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
        int index = crowd.index[body];
        if (selection != null && !selection.canReactWithWalls(crowd.bodies, index)) {
            return;
        }
        double[] state = crowd.state;
        int at = 8 * body;
        double x = state[at + X];
        double y = state[at + Y];
        double vx = state[at + VX];
        double vy = state[at + VY];
        double radius = crowd.ownRadius(body);
        double start = state[at + SINCE];
        for (int w = 0; w < walls.length; w++) {
            if (isLate(w, x, y, vx, vy, radius, start)
                || selection != null && !selection.canReactWithWall(crowd.bodies, index, w)) {
                continue;
            }
            if (crowd.exact) {
                offerExactWall(body, w, x, y, vx, vy, radius, start, crowd.low[4 * body + SINCE_LOW], now);
            } else {
                offerWall(w, x, y, vx, vy, radius, start, now);
            }
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
            if (selection == null) {
                offer(body, others[k], radius, state[8 * others[k] + RADIUS], now);
            } else {
                Bodies bodies = crowd.bodies;
                int i = crowd.index[body];
                int j = crowd.index[others[k]];
                if (selection.canReact(bodies, i, j)) {
                    offer(body, others[k], PairSelection.radius(selection, bodies, i, j),
                        PairSelection.radius(selection, bodies, j, i), now);
                }
            }
        }
    }

    /** Offers the next impact of a pair: the body whose flight starts earlier is moved to the start of the other. */
    private void offer(int body, int other, double ri, double rj, double now) {
        if (crowd.exact) {
            offerExact(body, other, ri, rj, now);
            return;
        }
        double[] state = crowd.state;
        int i = 8 * body;
        int j = 8 * other;
        double start = Math.max(state[i + SINCE], state[j + SINCE]);
        double flownI = start - state[i + SINCE];
        double flownJ = start - state[j + SINCE];
        double vxi = state[i + VX];
        double vyi = state[i + VY];
        double vxj = state[j + VX];
        double vyj = state[j + VY];
        offerPair(body, other, state[i + X] + vxi * flownI, state[j + X] + vxj * flownJ, state[i + Y] + vyi * flownI,
            state[j + Y] + vyj * flownJ, vxi, vxj, vyi, vyj, ri, rj, start, state[j + IMPACT], now);
    }

    /** As {@link #offer}, where times are double-doubles. */
    private void offerExact(int body, int other, double ri, double rj, double now) {
        double[] state = crowd.state;
        int i = 8 * body;
        int j = 8 * other;
        double sinceI = state[i + SINCE];
        double sinceJ = state[j + SINCE];
        double lowI = crowd.low[4 * body + SINCE_LOW];
        double lowJ = crowd.low[4 * other + SINCE_LOW];
        double ahead = sinceI != sinceJ ? sinceI - sinceJ : lowI - lowJ;
        double xi = state[i + X];
        double yi = state[i + Y];
        double xj = state[j + X];
        double yj = state[j + Y];
        if (ahead > 0) {
            double flown = flight.elapsed(sinceJ, lowJ, sinceI, lowI);
            xj = flight.coordinate(xj, state[j + VX], flown);
            yj = flight.coordinate(yj, state[j + VY], flown);
        } else if (ahead < 0) {
            double flown = flight.elapsed(sinceI, lowI, sinceJ, lowJ);
            xi = flight.coordinate(xi, state[i + VX], flown);
            yi = flight.coordinate(yi, state[i + VY], flown);
        }
        offerExactPair(body, other, xi, xj, yi, yj, state[i + VX], state[j + VX], state[i + VY], state[j + VY], ri, rj,
            ahead < 0 ? sinceJ : sinceI, ahead < 0 ? lowJ : lowI, state[j + IMPACT], now);
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
