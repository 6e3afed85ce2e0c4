package steward.physics.event.pairs;

import steward.physics.Bodies;
import steward.physics.PhysicsParts;
import steward.physics.event.flight.ImpactSearch;
import steward.physics.event.flight.PairSelection;
import steward.physics.time.PreciseFlight;
import steward.physics.time.SimultaneousImpacts;

/**
 * Next impact of each body with a body of a higher index, or with a wall: a row of the table of all pairs. After an
 * impact only rows in which something has changed are searched again.
 */
final class PairSearch extends ImpactSearch {

    /** Bound on what underflows in a sum of products. */
    private static final double TINY = 0x1p-1000;
    /** Sums of two times of a turn are off by at most this. */
    private static final double TIME_ROUNDING = 0x1p-52;
    /** Coordinates in flight for at most a turn are off by less than this share of place and velocity. */
    private static final double PLACE = 0x1p-48;

    /** The time of the next impact of each row; infinite for none in this turn. */
    double[] time = new double[0];
    /** Its partner: a body of a higher index, or {@code ~wall}. */
    int[] partner = new int[0];
    /** Where times are double-doubles, its low part, and whether another impact of the row is near it in time. */
    double[] timeLow = new double[0];
    private boolean[] doubtful = new boolean[0];
    private final boolean exact;
    private final PairFlights flights;
    private final PreciseFlight flight = new PreciseFlight();
    private final boolean bodiesMeet;

    PairSearch(PhysicsParts parts, PairFlights flights) {
        super(parts);
        this.flights = flights;
        exact = parts.arithmetic().isExact();
        bodiesMeet = parts.contacts().bodiesMeet();
    }

    /** Searches all rows; all flights start now. */
    void searchAll(Bodies bodies, double now) {
        int size = bodies.size();
        if (time.length < size) {
            time = new double[bodies.capacity()];
            partner = new int[bodies.capacity()];
            timeLow = new double[exact ? bodies.capacity() : 0];
            doubtful = new boolean[exact ? bodies.capacity() : 0];
        }
        for (int i = 0; i < size; i++) {
            clear();
            for (int j = i + 1; bodiesMeet && j < size; j++) {
                if (selection == null) {
                    double ri = bodies.radius[i];
                    double rj = bodies.radius[j];
                    if (!areLateTogether(bodies, i, j, ri, rj, now)) {
                        offerTogether(bodies, i, j, ri, rj, now, now);
                    }
                } else {
                    offerIfPossible(bodies, i, j, now);
                }
            }
            offerWalls(bodies, i, now);
            keep(i);
        }
    }

    /** Searches the rows in which something has changed. @param b a body, or negative */
    void searchAfter(Bodies bodies, int a, int b, double now) {
        for (int i = 0; i < bodies.size(); i++) {
            if (i == a || i == b || time[i] < NEVER && partner[i] >= 0 && (partner[i] == a || partner[i] == b)) {
                clear();
                offerRow(bodies, i, now);
                keep(i);
            } else if (bodiesMeet && (i < a || i < b)) {
                load(i);
                if (i < a) {
                    offerIfPossible(bodies, i, a, now);
                }
                if (i < b) {
                    offerIfPossible(bodies, i, b, now);
                }
                keep(i);
            }
        }
    }

    private void offerIfPossible(Bodies bodies, int i, int j, double now) {
        if (selection == null) {
            offer(bodies, i, j, bodies.radius[i], bodies.radius[j], now);
        } else if (selection.canReact(bodies, i, j)) {
            offer(bodies, i, j, PairSelection.radius(selection, bodies, i, j),
                PairSelection.radius(selection, bodies, j, i), now);
        }
    }

    private void offerRow(Bodies bodies, int i, double now) {
        for (int j = i + 1; bodiesMeet && j < bodies.size(); j++) {
            offerIfPossible(bodies, i, j, now);
        }
        offerWalls(bodies, i, now);
    }

    private void offerWalls(Bodies bodies, int i, double now) {
        if (selection != null && !selection.canReactWithWalls(bodies, i)) {
            return;
        }
        if (exact) {
            offerExactWalls(bodies, i, now);
            return;
        }
        for (int w = 0; w < walls.length; w++) {
            if (selection == null || selection.canReactWithWall(bodies, i, w)) {
                offerWall(w, bodies.x[i], bodies.y[i], bodies.vx[i], bodies.vy[i], bodies.radius[i],
                    flights.since[i], now);
            }
        }
    }

    private void offerExactWalls(Bodies bodies, int i, double now) {
        double x = bodies.x[i];
        double y = bodies.y[i];
        double vx = bodies.vx[i];
        double vy = bodies.vy[i];
        double radius = bodies.radius[i];
        double start = flights.since[i];
        for (int w = 0; w < walls.length; w++) {
            if (!isLate(w, x, y, vx, vy, radius, start)
                && (selection == null || selection.canReactWithWall(bodies, i, w))) {
                offerExactWall(i, w, x, y, vx, vy, radius, start, flights.sinceLow[i], now);
            }
        }
    }

    private void load(int i) {
        best = time[i];
        bestPartner = partner[i];
        if (exact) {
            bestLow = timeLow[i];
            bestDoubtful = doubtful[i];
        }
    }

    private void keep(int i) {
        time[i] = best;
        partner[i] = bestPartner;
        if (exact) {
            timeLow[i] = bestLow;
            doubtful[i] = bestDoubtful;
        }
    }

    @Override
    protected long rank(int body, int other) {
        return SimultaneousImpacts.rank(body, other);
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

    /** The impacts at the time of the earliest row, or {@code null} if no other is near it. */
    SimultaneousImpacts simultaneous(Bodies bodies, int first) {
        double now = time[first];
        double limit = now + SimultaneousImpacts.NEAR;
        boolean alone = !doubtful[first];
        for (int i = 0; i < bodies.size() && alone; i++) {
            alone = i == first || !(time[i] - now <= SimultaneousImpacts.NEAR);
        }
        if (alone) {
            return null;
        }
        together.clear();
        collects = true;
        for (int i = 0; i < bodies.size(); i++) {
            if (time[i] <= limit) {
                best = limit;
                offerRow(bodies, i, now);
            }
        }
        collects = false;
        together.decide();
        return together;
    }

    /** {@link #isLate} of a pair, both flights of which start at one time: most pairs need no more. */
    private boolean areLateTogether(Bodies bodies, int i, int j, double ri, double rj, double start) {
        return isLate(bodies.x[i] - bodies.x[j], bodies.y[i] - bodies.y[j], bodies.vx[i] - bodies.vx[j],
            bodies.vy[i] - bodies.vy[j], ri + rj, Math.min(best, 1) - start);
    }

    /** Offers the next impact of a pair, both flights of which start at one time. */
    private void offerTogether(Bodies bodies, int i, int j, double ri, double rj, double start, double now) {
        if (exact) {
            offerExact(i, j, bodies.x[i], bodies.x[j], bodies.y[i], bodies.y[j], bodies.vx[i], bodies.vx[j],
                bodies.vy[i], bodies.vy[j], ri, rj, start, flights.sinceLow[i], now);
        } else {
            offerPair(i, j, bodies.x[i], bodies.x[j], bodies.y[i], bodies.y[j], bodies.vx[i], bodies.vx[j],
                bodies.vy[i], bodies.vy[j], ri, rj, start, NEVER, now);
        }
    }

    /** Offers the next impact of a pair, whenever its flights have started: the earlier one is moved to the later. */
    private void offer(Bodies bodies, int i, int j, double ri, double rj, double now) {
        if (exact) {
            offerExact(bodies, i, j, ri, rj, now);
            return;
        }
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
        if (!isLate(xi - xj, yi - yj, vxi - vxj, vyi - vyj, ri + rj, Math.min(best, 1) - start)) {
            offerPair(i, j, xi, xj, yi, yj, vxi, vxj, vyi, vyj, ri, rj, start, NEVER, now);
        }
    }

    /** As {@link #offer}, where times are double-doubles. */
    private void offerExact(Bodies bodies, int i, int j, double ri, double rj, double now) {
        double ahead = flights.clockDifference(i, j);
        if (ahead == 0) {
            if (!areLateTogether(bodies, i, j, ri, rj, flights.since[i])) {
                offerTogether(bodies, i, j, ri, rj, flights.since[i], now);
            }
        } else if (!areSurelyLate(bodies, ahead > 0 ? j : i, ahead > 0 ? i : j, ri + rj)) {
            offerFlown(bodies, i, j, ri, rj, ahead > 0 ? i : j, now);
        }
    }

    /** Moves the one whose flight has started earlier to the start of the other's. */
    private void offerFlown(Bodies bodies, int i, int j, double ri, double rj, int later, double now) {
        int earlier = i + j - later;
        double start = flights.since[later];
        double startLow = flights.sinceLow[later];
        double flown = flight.elapsed(flights.since[earlier], flights.sinceLow[earlier], start, startLow);
        double vx = bodies.vx[earlier];
        double vy = bodies.vy[earlier];
        double x = flight.coordinate(bodies.x[earlier], vx, flown);
        double y = flight.coordinate(bodies.y[earlier], vy, flown);
        double toX = bodies.x[later];
        double toY = bodies.y[later];
        if (!isLate(x - toX, y - toY, vx - bodies.vx[later], vy - bodies.vy[later], ri + rj,
            Math.min(best, 1) - start)) {
            boolean isFirst = earlier == i;
            offerExact(i, j, isFirst ? x : toX, isFirst ? toX : x, isFirst ? y : toY, isFirst ? toY : y, bodies.vx[i],
                bodies.vx[j], bodies.vy[i], bodies.vy[j], ri, rj, start, startLow, now);
        }
    }

    private void offerExact(int i, int j, double xi, double xj, double yi, double yj, double vxi, double vxj,
                            double vyi, double vyj, double ri, double rj, double start, double startLow, double now) {
        if (start + exactPairs.lowerBound(xi, xj, yi, yj, vxi, vxj, vyi, vyj, ri, rj) <= Math.min(best, 1)) {
            offerExactPair(i, j, xi, xj, yi, yj, vxi, vxj, vyi, vyj, ri, rj, start, startLow, NEVER, now);
        }
    }

    /**
     * {@link #isLate} for a body that has flown for some time and another whose flight starts later: in plain doubles,
     * with room for their rounding, before the flight is computed in double-double.
     */
    private boolean areSurelyLate(Bodies bodies, int flying, int starting, double touch) {
        double x = bodies.x[flying];
        double y = bodies.y[flying];
        double vx = bodies.vx[flying];
        double vy = bodies.vy[flying];
        double start = flights.since[starting];
        double flown = start - flights.since[flying];
        double rounding = PLACE * (Math.abs(x) + Math.abs(y) + Math.abs(vx) + Math.abs(vy)) + Double.MIN_NORMAL;
        return isLate(x + vx * flown - bodies.x[starting], y + vy * flown - bodies.y[starting],
            vx - bodies.vx[starting], vy - bodies.vy[starting], touch + rounding, Math.min(best, 1) - start, rounding);
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
}
