package steward.physics.queue;

import static steward.physics.queue.Crowd.EVENT;
import static steward.physics.queue.Crowd.IMPACT;
import static steward.physics.queue.Crowd.IMPACT_LOW;
import static steward.physics.queue.Crowd.PARTNER;
import static steward.physics.queue.Crowd.RADIUS;
import static steward.physics.queue.Crowd.SINCE;
import static steward.physics.queue.Crowd.SINCE_LOW;
import static steward.physics.queue.Crowd.VX;
import static steward.physics.queue.Crowd.VY;
import static steward.physics.queue.Crowd.X;
import static steward.physics.queue.Crowd.Y;

import steward.numerics.DoubleDouble;
import steward.physics.Arithmetic;
import steward.physics.Wall;
import steward.physics.event.EventAdvance;
import steward.physics.time.ExactPairs;
import steward.physics.time.ExactWalls;
import steward.physics.time.SimultaneousImpacts;

/**
 * The search with exact decisions and times in double-double. Of a pair, the body whose flight started last is taken at
 * its stored position; the other is moved to that time with one rounding, as {@link EventAdvance} does, and signs and
 * times are exact for these positions.
 */
final class ExactQueueSearch extends QueueSearch {

    private final ExactPairs exactPairs;
    private final ExactWalls exactWalls;
    private final DoubleDouble until = new DoubleDouble();
    private final DoubleDouble time = new DoubleDouble();
    private final SimultaneousImpacts together;
    private double bestLow;
    /** Of each body: whether another impact of it is near its prediction in time. */
    private boolean[] doubtful = new boolean[0];
    /** True if impacts near a time are collected in place of the earliest. */
    private boolean collects;

    ExactQueueSearch(Crowd crowd, EventBuckets events, Wall[] walls, QueuePairs pairs, ExactPairs exactPairs,
                     ExactWalls exactWalls) {
        super(crowd, events, Arithmetic.EXACT, walls, pairs);
        this.exactPairs = exactPairs;
        this.exactWalls = exactWalls;
        together = new SimultaneousImpacts(walls);
    }

    @Override
    void begin(int capacity) {
        super.begin(capacity);
        if (doubtful.length < capacity) {
            doubtful = new boolean[capacity];
        }
    }

    @Override
    boolean mayBeSimultaneous(int body, double now) {
        int partner = crowd.link[8 * body + PARTNER];
        if (doubtful[body] || partner >= 0 && doubtful[partner] && isNear(partner, now)) {
            return true;
        }
        boolean mirrored = partner >= 0 && crowd.link[8 * partner + PARTNER] == body
            && crowd.link[8 * partner + EVENT] == 0 && isNear(partner, now);
        events.remove(body);                               // both are predicted anew after their impact
        if (mirrored) {
            events.remove(partner);
        }
        int next = events.first();
        boolean near = next >= 0 && events.time(next) - now <= SimultaneousImpacts.NEAR;
        if (near) {
            events.put(body, now);
            if (mirrored) {
                events.put(partner, crowd.state[8 * partner + IMPACT]);
            }
        }
        return near;
    }

    private boolean isNear(int body, double now) {
        return crowd.state[8 * body + IMPACT] - now <= SimultaneousImpacts.NEAR;
    }

    @Override
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
    boolean areApproaching(int a, int b) {
        double[] state = crowd.state;
        int i = 8 * a;
        int j = 8 * b;
        return b < 0
            ? exactWalls.approaches(~b, state[i + X], state[i + Y], state[i + VX], state[i + VY], state[i + RADIUS])
            : exactPairs.areApproaching(state[i + X], state[j + X], state[i + Y], state[j + Y], state[i + VX],
                state[j + VX], state[i + VY], state[j + VY]);
    }

    @Override
    void storePrediction(int body) {
        crowd.low[4 * body + IMPACT_LOW] = best < Crowd.NEVER ? bestLow : 0;
    }

    @Override
    void loadPrediction(int body) {
        bestLow = crowd.low[4 * body + IMPACT_LOW];
    }

    @Override
    void offerWall(int body, int w, double now) {
        int at = 8 * body;
        double[] state = crowd.state;
        double since = state[at + SINCE];
        double x = state[at + X];
        double y = state[at + Y];
        double vx = state[at + VX];
        double vy = state[at + VY];
        double radius = state[at + RADIUS];
        if (since + exactWalls.until(w, x, y, vx, vy, radius) <= Math.min(best, 1)
            && exactWalls.exactTime(w, x, y, vx, vy, radius, until)) {
            boolean isPresent = addTimes(since, crowd.low[4 * body + SINCE_LOW], now);
            if (!collects) {
                keepIfEarlier(body, ~w);
            } else if (isNear()) {
                together.addWall(body, w, EventOrder.rank(crowd, body, ~w), x, y, vx, vy, radius, since,
                    crowd.low[4 * body + SINCE_LOW], until, time, isPresent);
            }
        }
    }

    @Override
    void offer(int body, int other, double now) {
        double[] state = crowd.state;
        int i = 8 * body;
        int j = 8 * other;
        double xi = state[i + X];
        double yi = state[i + Y];
        double xj = state[j + X];
        double yj = state[j + Y];
        double since = state[i + SINCE];
        double sinceLow = crowd.low[4 * body + SINCE_LOW];
        double ahead = crowd.clockDifference(body, other);
        if (ahead > 0) {
            crowd.nowLow = sinceLow;
            double time = crowd.elapsed(other, since);
            xj = crowd.coordinateAfter(xj, state[j + VX], time);
            yj = crowd.coordinateAfter(yj, state[j + VY], time);
        } else if (ahead < 0) {
            since = state[j + SINCE];
            sinceLow = crowd.low[4 * other + SINCE_LOW];
            crowd.nowLow = sinceLow;
            double time = crowd.elapsed(body, since);
            xi = crowd.coordinateAfter(xi, state[i + VX], time);
            yi = crowd.coordinateAfter(yi, state[i + VY], time);
        }
        if (exactPairs.exactTime(xi, xj, yi, yj, state[i + VX], state[j + VX], state[i + VY], state[j + VY],
            state[i + RADIUS], state[j + RADIUS], until)) {
            boolean isPresent = addTimes(since, sinceLow, now);
            if (!collects) {
                keepIfEarlier(body, other);
            } else if (isNear()) {
                together.addPair(body, other, EventOrder.rank(crowd, body, other), xi, xj, yi, yj, state[i + VX],
                    state[j + VX], state[i + VY], state[j + VY], state[i + RADIUS], state[j + RADIUS], since,
                    sinceLow, until, time, isPresent);
            }
        }
    }

    /** Computes the time of the turn; one before the present is so only by rounding. @return whether it was */
    private boolean addTimes(double since, double sinceLow, double now) {
        time.setSum(since, sinceLow).add(until);
        if (time.high() < now) {
            time.set(now);
            return true;
        }
        return false;
    }

    private boolean isNear() {
        return time.high() <= best && isWithinTurn();
    }

    private boolean isWithinTurn() {
        return time.high() < 1 || time.high() == 1 && time.low() <= 0;
    }

    private void keepIfEarlier(int body, int other) {
        double high = time.high();
        double low = time.low();
        double later = high - best;
        if (!isWithinTurn() || later > SimultaneousImpacts.NEAR
            || other >= 0 && high - crowd.state[8 * other + IMPACT] > SimultaneousImpacts.NEAR) {
            return;
        }
        doubtful[body] = later >= -SimultaneousImpacts.NEAR;
        if (high < best || high == best && (low < bestLow || low == bestLow && other >= 0 && isLower(body, other))) {
            best = high;
            bestLow = low;
            partner = other;
        }
    }
}
