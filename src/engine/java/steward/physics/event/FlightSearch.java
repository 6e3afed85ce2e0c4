package steward.physics.event;

import steward.physics.Bodies;
import steward.physics.PhysicsParts;
import steward.physics.Wall;
import steward.physics.time.CircleTime;
import steward.physics.time.ContactDistance;
import steward.physics.time.SimultaneousImpacts;
import steward.physics.time.TimeOfImpact;

/**
 * The next impact of each body with a body of a higher index, or with a wall: a row of the table of all pairs. A time
 * of impact is computed from the positions at the later start of the two flights, so that it is the same whenever it is
 * searched for; after an impact only the rows are searched again in which something has changed. Ties go to the lowest
 * pair, bodies before walls.
 */
sealed class FlightSearch permits PreciseFlightSearch {

    /** Sums of products are off by less than this share of their terms. */
    private static final double ROUNDING = 0x1p-46;
    /** Bound on what underflows in a sum of products. */
    private static final double TINY = 0x1p-1000;
    /** Sums of two times of a turn are off by at most this. */
    private static final double TIME_ROUNDING = 0x1p-52;

    static final double NEVER = Double.POSITIVE_INFINITY;

    /** The time of the next impact of each row; infinite for none in this turn. */
    double[] time = new double[0];
    /** Its partner: a body of a higher index, or {@code ~wall}. */
    int[] partner = new int[0];
    final Wall[] walls;
    private final Flights flights;
    private final CircleTime circles;
    private final boolean bodiesMeet;
    private final PairSelection selection;
    /** {@code null} if no contact begins at a distance of its own. */
    private final ContactDistance distance;
    /** The earliest impact of the row in work. */
    double best;
    int bestPartner;

    FlightSearch(PhysicsParts parts, Flights flights, Wall[] walls) {
        this.flights = flights;
        this.walls = walls;
        circles = CircleTime.of(parts.arithmetic());
        bodiesMeet = parts.contacts().bodiesMeet();
        selection = parts.contacts().allBounce() && !parts.infiniteMasses()
            ? null : new PairSelection(parts.contacts());
        distance = parts.contacts().hasReaches() ? new ContactDistance(parts.contacts()) : null;
    }

    /** Searches all rows; all flights start now. */
    void searchAll(Bodies bodies, double now) {
        int size = bodies.size();
        if (time.length < size) {
            grow(bodies.capacity());
        }
        for (int i = 0; i < size; i++) {
            clear();
            for (int j = i + 1; bodiesMeet && j < size; j++) {
                if (selection == null) {
                    offerAtStart(bodies, i, j, now);
                } else {
                    offerIfSelected(bodies, i, j, now);
                }
            }
            offerWalls(bodies, i, now);
            keep(i);
        }
    }

    void grow(int capacity) {
        time = new double[capacity];
        partner = new int[capacity];
    }

    /** Searches the rows in which something has changed. @param b a body, or negative */
    void searchAfter(Bodies bodies, int a, int b, double now) {
        for (int i = 0; i < bodies.size(); i++) {
            if (i == a || i == b || time[i] < NEVER && partner[i] >= 0 && (partner[i] == a || partner[i] == b)) {
                searchRow(bodies, i, now);
            } else if (bodiesMeet && (i < a || i < b)) {
                load(i);
                offerIfHigher(bodies, i, a, now);
                offerIfHigher(bodies, i, b, now);
                keep(i);
            }
        }
    }

    private void offerIfHigher(Bodies bodies, int i, int j, double now) {
        if (j > i) {
            offerIfPossible(bodies, i, j, now);
        }
    }

    private void offerIfPossible(Bodies bodies, int i, int j, double now) {
        if (selection == null) {
            offer(bodies, i, j, now);
        } else {
            offerIfSelected(bodies, i, j, now);
        }
    }

    private void offerIfSelected(Bodies bodies, int i, int j, double now) {
        if (selection.canReact(bodies, i, j)) {
            boolean own = distance != null && distance.enter(bodies, i, j);
            offer(bodies, i, j, now);
            if (own) {
                distance.leave(bodies, i, j);
            }
        }
    }

    private void searchRow(Bodies bodies, int i, double now) {
        clear();
        offerRow(bodies, i, now);
        keep(i);
    }

    final void offerRow(Bodies bodies, int i, double now) {
        for (int j = i + 1; bodiesMeet && j < bodies.size(); j++) {
            offerIfPossible(bodies, i, j, now);
        }
        offerWalls(bodies, i, now);
    }

    private void offerWalls(Bodies bodies, int i, double now) {
        if (walls.length > 0
            && (selection == null ? bodies.inverseMass[i] > 0 : selection.canReactWithWalls(bodies, i))) {
            for (int w = 0; w < walls.length; w++) {
                if (selection == null || selection.canReactWithWall(bodies, i, w)) {
                    offerWall(bodies, i, w, now);
                }
            }
        }
    }

    void clear() {
        best = NEVER;
    }

    void load(int i) {
        best = time[i];
        bestPartner = partner[i];
    }

    void keep(int i) {
        time[i] = best;
        partner[i] = bestPartner;
    }

    /** The row with the earliest impact, or -1. */
    int earliest(int rows) {
        int first = -1;
        double earliest = NEVER;
        for (int i = 0; i < rows; i++) {
            if (time[i] < earliest) {
                earliest = time[i];
                first = i;
            }
        }
        return first;
    }

    /**
     * The impacts at the time of the earliest one, where that has to be decided by other means than the order of times:
     * {@code null} for one alone.
     */
    SimultaneousImpacts simultaneous(Bodies bodies, double now) {
        return null;
    }

    /** True if the partners of an impact approach; both have been moved to it. */
    boolean areApproaching(Bodies bodies, int a, int b) {
        return true;
    }

    /** Keeps the impact of a pair, i below j, both flights of which start now, if it is earlier than the row's best. */
    void offerAtStart(Bodies bodies, int i, int j, double now) {
        if (!areLateAtStart(bodies, i, j, now)) {
            offer(j, bodies.x[i], bodies.x[j], bodies.y[i], bodies.y[j], bodies.vx[i], bodies.vx[j], bodies.vy[i],
                bodies.vy[j], bodies.radius[i], bodies.radius[j], now, now);
        }
    }

    /** {@link #isLate} of a pair, both flights of which start now: most pairs need no more. */
    final boolean areLateAtStart(Bodies bodies, int i, int j, double now) {
        return isLate(bodies.x[i] - bodies.x[j], bodies.y[i] - bodies.y[j], bodies.vx[i] - bodies.vx[j],
            bodies.vy[i] - bodies.vy[j], bodies.radius[i] + bodies.radius[j], Math.min(best, 1) - now);
    }

    /** Offers the next impact of a pair, whenever its flights have started. */
    void offer(Bodies bodies, int i, int j, double now) {
        double xi = bodies.x[i];
        double yi = bodies.y[i];
        double xj = bodies.x[j];
        double yj = bodies.y[j];
        double vxi = bodies.vx[i];
        double vyi = bodies.vy[i];
        double vxj = bodies.vx[j];
        double vyj = bodies.vy[j];
        double start = flights.since[i];
        double other = flights.since[j];
        if (start > other) {
            xj += vxj * (start - other);
            yj += vyj * (start - other);
        } else if (start < other) {
            xi += vxi * (other - start);
            yi += vyi * (other - start);
            start = other;
        }
        double touch = bodies.radius[i] + bodies.radius[j];
        if (!isLate(xi - xj, yi - yj, vxi - vxj, vyi - vyj, touch, Math.min(best, 1) - start)) {
            offer(j, xi, xj, yi, yj, vxi, vxj, vyi, vyj, bodies.radius[i], bodies.radius[j], start, now);
        }
    }

    private void offer(int j, double xi, double xj, double yi, double yj, double vxi, double vxj, double vyi,
                       double vyj, double ri, double rj, double start, double now) {
        double until = circles.untilInTurn(xi, xj, yi, yj, vxi, vxj, vyi, vyj, ri, rj, start);
        if (until < NEVER) {
            double at = Math.max(now, start + until);
            if (at < best || at == best && isLower(j)) {
                best = at;
                bestPartner = j;
            }
        }
    }

    /**
     * True if a pair surely separates, or surely does not touch within a time: the squared distance less s^2 is at
     * least c + 2 b t. Without a root or a division, for most pairs. A sum that overflows or underflows is not sure.
     */
    static boolean isLate(double dx, double dy, double dvx, double dvy, double touch, double left) {
        double xvx = dx * dvx;
        double yvy = dy * dvy;
        return isFar(dx, dy, xvx + yvy, ROUNDING * (Math.abs(xvx) + Math.abs(yvy)) + TINY, touch, left);
    }

    /** True if a pair is surely late where dx and dy are off by {@code rounding}, which is in {@code touch} already. */
    static boolean isLate(double dx, double dy, double dvx, double dvy, double touch, double left, double rounding) {
        double xvx = dx * dvx;
        double yvy = dy * dvy;
        return isFar(dx, dy, xvx + yvy,
            ROUNDING * (Math.abs(xvx) + Math.abs(yvy)) + rounding * (Math.abs(dvx) + Math.abs(dvy)) + TINY,
            touch, left);
    }

    private static boolean isFar(double dx, double dy, double b, double doubt, double touch, double left) {
        if (b > doubt) {
            return true;
        }
        double squared = dx * dx + dy * dy;
        double ss = touch * touch;
        return squared - ss - (ROUNDING * (squared + ss) + TINY) + 2 * (b - doubt) * (left + TIME_ROUNDING) > 0;
    }

    /** For equal times: whether a body comes before the best partner so far. */
    final boolean isLower(int j) {
        return bestPartner < 0 || j < bestPartner;
    }

    void offerWall(Bodies bodies, int i, int w, double now) {
        double since = flights.since[i];
        double until = TimeOfImpact.wall(walls[w], bodies.x[i], bodies.y[i], bodies.vx[i], bodies.vy[i],
            bodies.radius[i]);
        if (until <= 1 - since && Math.max(now, since + until) < best) {
            best = Math.max(now, since + until);
            bestPartner = ~w;
        }
    }
}
