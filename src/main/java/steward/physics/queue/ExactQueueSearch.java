package steward.physics.queue;

import static steward.physics.queue.Crowd.IMPACT;
import static steward.physics.queue.Crowd.IMPACT_LOW;
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
    private double bestLow;

    ExactQueueSearch(Crowd crowd, EventBuckets events, Wall[] walls, QueuePairs pairs, ExactPairs exactPairs,
                     ExactWalls exactWalls) {
        super(crowd, events, Arithmetic.EXACT, walls, pairs);
        this.exactPairs = exactPairs;
        this.exactWalls = exactWalls;
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
            keepIfEarlier(body, ~w, since, crowd.low[4 * body + SINCE_LOW], now);
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
            keepIfEarlier(body, other, since, sinceLow, now);
        }
    }

    private void keepIfEarlier(int body, int other, double since, double sinceLow, double now) {
        time.setSum(since, sinceLow).add(until);
        double high = time.high();
        double low = time.low();
        if (high < now) {
            high = now;                                // only by rounding
            low = 0;
        }
        if (high > 1 || high == 1 && low > 0 || high > best || high == best && low > bestLow) {
            return;
        }
        if (other >= 0) {
            double others = crowd.state[8 * other + IMPACT];
            if (high > others || high == others && low > crowd.low[4 * other + IMPACT_LOW]) {
                return;
            }
        }
        boolean earlier = high < best || low < bestLow;
        if (earlier || other >= 0 && isLower(body, other)) {
            best = high;
            bestLow = low;
            partner = other;
        }
    }
}
