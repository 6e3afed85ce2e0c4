package steward.physics.event;

import steward.numerics.DoubleDouble;
import steward.physics.Bodies;
import steward.physics.PhysicsParts;
import steward.physics.Wall;
import steward.physics.time.ExactPairs;
import steward.physics.time.ExactWalls;
import steward.physics.time.PreciseFlight;
import steward.physics.time.SimultaneousImpacts;

/**
 * The search with exact decisions, and with times in double-double. Where two of these are so near that they may be the
 * same time, {@link SimultaneousImpacts} decides.
 */
final class PreciseFlightSearch extends FlightSearch {

    /** Coordinates in flight for at most a turn are off by less than this share of place and velocity. */
    private static final double PLACE = 0x1p-48;

    private double[] timeLow = new double[0];
    private final Flights.Precise flights;
    private final ExactPairs pairs;
    private final ExactWalls exactWalls;
    private final PreciseFlight flight = new PreciseFlight();
    private final DoubleDouble until = new DoubleDouble();
    private final DoubleDouble at = new DoubleDouble();
    private final SimultaneousImpacts together;
    private double bestLow;
    /** Of each row, and of the row in work: whether another impact of it is near its best in time. */
    private boolean[] doubtful = new boolean[0];
    private boolean bestDoubtful;
    /** True if another impact is near the earliest. */
    private boolean earliestDoubtful;
    /** The row whose impacts are collected, or -1 while the earliest are searched for. */
    private int collected = -1;

    PreciseFlightSearch(PhysicsParts parts, Flights.Precise flights, Wall[] walls, ExactPairs pairs,
                        ExactWalls exactWalls) {
        super(parts, flights, walls);
        this.flights = flights;
        this.pairs = pairs;
        this.exactWalls = exactWalls;
        together = new SimultaneousImpacts(walls);
    }

    @Override
    void grow(int capacity) {
        super.grow(capacity);
        timeLow = new double[capacity];
        doubtful = new boolean[capacity];
    }

    @Override
    void clear() {
        super.clear();
        bestLow = 0;
        bestDoubtful = false;
    }

    @Override
    void load(int i) {
        super.load(i);
        bestLow = timeLow[i];
        bestDoubtful = doubtful[i];
    }

    @Override
    void keep(int i) {
        super.keep(i);
        timeLow[i] = bestLow;
        doubtful[i] = bestDoubtful;
    }

    @Override
    int earliest(int rows) {
        int first = -1;
        double earliest = NEVER;
        double second = NEVER;
        for (int i = 0; i < rows; i++) {
            if (time[i] < earliest) {
                second = earliest;
                earliest = time[i];
                first = i;
            } else if (time[i] < second) {
                second = time[i];
            }
        }
        earliestDoubtful = first >= 0 && (second - earliest <= SimultaneousImpacts.NEAR || doubtful[first]);
        flights.setNowLow(first < 0 ? 0 : timeLow[first]);
        return first;
    }

    @Override
    SimultaneousImpacts simultaneous(Bodies bodies, double now) {
        if (!earliestDoubtful) {
            return null;
        }
        together.clear();
        double limit = now + SimultaneousImpacts.NEAR;
        for (int i = 0; i < bodies.size(); i++) {
            if (time[i] <= limit) {
                collected = i;
                best = limit;
                offerRow(bodies, i, now);
            }
        }
        collected = -1;
        together.decide();
        return together;
    }

    @Override
    boolean areApproaching(Bodies bodies, int a, int b) {
        return b < 0 ? exactWalls.areApproaching(bodies, a, ~b) : pairs.areApproaching(bodies, a, b);
    }

    @Override
    void offerAtStart(Bodies bodies, int i, int j, double now) {
        offerTogether(bodies, i, j, now, now);
    }

    /** For flights that start at the same time. */
    private void offerTogether(Bodies bodies, int i, int j, double start, double now) {
        if (!areLateAtStart(bodies, i, j, start)) {
            offer(j, bodies.x[i], bodies.x[j], bodies.y[i], bodies.y[j], bodies.vx[i], bodies.vx[j], bodies.vy[i],
                bodies.vy[j], bodies.radius[i], bodies.radius[j], start, flights.sinceLow[i], now);
        }
    }

    @Override
    void offer(Bodies bodies, int i, int j, double now) {
        double ahead = flights.clockDifference(i, j);
        if (ahead > 0) {
            if (!areSurelyLate(bodies, j, i)) {
                offerFlown(bodies, i, j, ahead, now);
            }
        } else if (ahead < 0) {
            if (!areSurelyLate(bodies, i, j)) {
                offerFlown(bodies, i, j, ahead, now);
            }
        } else {
            offerTogether(bodies, i, j, flights.since[i], now);
        }
    }

    /**
     * {@link #isLate} for a body that has flown for some time and another whose flight starts later: in plain
     * doubles, with room for their rounding, before the flight is computed in double-double.
     */
    private boolean areSurelyLate(Bodies bodies, int flying, int starting) {
        double x = bodies.x[flying];
        double y = bodies.y[flying];
        double vx = bodies.vx[flying];
        double vy = bodies.vy[flying];
        double start = flights.since[starting];
        double flown = start - flights.since[flying];
        double rounding = PLACE * (Math.abs(x) + Math.abs(y) + Math.abs(vx) + Math.abs(vy)) + Double.MIN_NORMAL;
        return isLate(x + vx * flown - bodies.x[starting], y + vy * flown - bodies.y[starting],
            vx - bodies.vx[starting], vy - bodies.vy[starting],
            bodies.radius[flying] + bodies.radius[starting] + rounding, Math.min(best, 1) - start, rounding);
    }

    /** Moves the one whose flight has started earlier to the start of the other's. */
    private void offerFlown(Bodies bodies, int i, int j, double ahead, double now) {
        double xi = bodies.x[i];
        double yi = bodies.y[i];
        double xj = bodies.x[j];
        double yj = bodies.y[j];
        double vxi = bodies.vx[i];
        double vyi = bodies.vy[i];
        double vxj = bodies.vx[j];
        double vyj = bodies.vy[j];
        int later = ahead > 0 ? i : j;
        int earlier = ahead > 0 ? j : i;
        double start = flights.since[later];
        double startLow = flights.sinceLow[later];
        double flown = flight.elapsed(flights.since[earlier], flights.sinceLow[earlier], start, startLow);
        if (ahead > 0) {
            xj = flight.coordinate(xj, vxj, flown);
            yj = flight.coordinate(yj, vyj, flown);
        } else {
            xi = flight.coordinate(xi, vxi, flown);
            yi = flight.coordinate(yi, vyi, flown);
        }
        double touch = bodies.radius[i] + bodies.radius[j];
        if (!isLate(xi - xj, yi - yj, vxi - vxj, vyi - vyj, touch, Math.min(best, 1) - start)) {
            offer(j, xi, xj, yi, yj, vxi, vxj, vyi, vyj, bodies.radius[i], bodies.radius[j], start, startLow, now);
        }
    }

    private void offer(int j, double xi, double xj, double yi, double yj, double vxi, double vxj, double vyi,
                       double vyj, double ri, double rj, double start, double startLow, double now) {
        if (start + pairs.lowerBound(xi, xj, yi, yj, vxi, vxj, vyi, vyj, ri, rj) <= Math.min(best, 1)
            && pairs.exactTime(xi, xj, yi, yj, vxi, vxj, vyi, vyj, ri, rj, until)) {
            boolean isPresent = addTimes(start, startLow, now);
            if (collected < 0) {
                keepIfEarlier(j);
            } else if (isNear()) {
                together.addPair(collected, j, ImpactQueue.OneAtATime.rank(collected, j), xi, xj, yi, yj, vxi, vxj,
                    vyi, vyj, ri, rj, start, startLow, until, at, isPresent);
            }
        }
    }

    @Override
    void offerWall(Bodies bodies, int i, int w, double now) {
        double x = bodies.x[i];
        double y = bodies.y[i];
        double vx = bodies.vx[i];
        double vy = bodies.vy[i];
        double radius = bodies.radius[i];
        double since = flights.since[i];
        if (since + exactWalls.until(w, x, y, vx, vy, radius) <= Math.min(best, 1)
            && exactWalls.exactTime(w, x, y, vx, vy, radius, until)) {
            boolean isPresent = addTimes(since, flights.sinceLow[i], now);
            if (collected < 0) {
                keepIfEarlier(~w);
            } else if (isNear()) {
                together.addWall(i, w, ImpactQueue.OneAtATime.rank(i, ~w), x, y, vx, vy, radius, since,
                    flights.sinceLow[i], until, at, isPresent);
            }
        }
    }

    /** Computes the time of the turn; one before the present is so only by rounding. @return whether it was */
    private boolean addTimes(double start, double startLow, double now) {
        at.setSum(start, startLow).add(until);
        if (at.high() < now) {
            at.set(now);
            return true;
        }
        return false;
    }

    private boolean isNear() {
        return at.high() <= best && isWithinTurn();
    }

    private boolean isWithinTurn() {
        return at.high() < 1 || at.high() == 1 && at.low() <= 0;
    }

    private void keepIfEarlier(int other) {
        double high = at.high();
        double low = at.low();
        double later = high - best;
        if (!isWithinTurn() || later > SimultaneousImpacts.NEAR) {
            return;
        }
        bestDoubtful = later >= -SimultaneousImpacts.NEAR;
        if (high < best || high == best && (low < bestLow || low == bestLow && other >= 0 && isLower(other))) {
            best = high;
            bestLow = low;
            bestPartner = other;
        }
    }
}
