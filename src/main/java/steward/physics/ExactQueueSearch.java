package steward.physics;

import static steward.physics.Crowd.IMPACT;
import static steward.physics.Crowd.IMPACT_LOW;
import static steward.physics.Crowd.RADIUS;
import static steward.physics.Crowd.SINCE;
import static steward.physics.Crowd.SINCE_LOW;
import static steward.physics.Crowd.VX;
import static steward.physics.Crowd.VY;
import static steward.physics.Crowd.X;
import static steward.physics.Crowd.Y;

import steward.numerics.DoubleDouble;

/**
 * The same with exact decisions and times in double-double. Of a pair, the one that changed its flight last is where it
 * is stored; the other is flown there and rounded once, as {@link EventAdvance} does, and signs and times are exact for
 * these places.
 */
final class ExactQueueSearch extends QueueSearch {

    private final ExactPairs exactPairs;
    private final ExactWalls exactWalls;
    private final Bodies two = new Bodies(2);
    private final DoubleDouble until = new DoubleDouble();
    private final DoubleDouble time = new DoubleDouble();
    private double bestLow;

    ExactQueueSearch(Crowd crowd, EventBuckets events, Wall[] walls, QueuePairs pairs, ExactPairs exactPairs,
                     ExactWalls exactWalls) {
        super(crowd, events, Arithmetic.EXACT, walls, pairs);
        this.exactPairs = exactPairs;
        this.exactWalls = exactWalls;
        two.add(0, 0, 1, 1);
        two.add(0, 0, 1, 1);
    }

    @Override
    void found(int body) {
        crowd.low[4 * body + IMPACT_LOW] = best < Crowd.NEVER ? bestLow : 0;
    }

    @Override
    void known(int body) {
        bestLow = crowd.low[4 * body + IMPACT_LOW];
    }

    @Override
    void offerWall(int body, int w, double now) {
        crowd.nowLow = crowd.low[4 * body + SINCE_LOW];
        double since = crowd.state[8 * body + SINCE];
        copy(body, 0, since);
        if (since + exactWalls.until(two, 0, w) <= Math.min(best, 1) && exactWalls.exact(two, 0, w, until)) {
            keepIfEarlier(body, ~w, since, now);
        }
    }

    @Override
    void offer(int body, int other, double now) {
        int later = crowd.isLater(body, other) ? body : other;
        crowd.nowLow = crowd.low[4 * later + SINCE_LOW];
        double since = crowd.state[8 * later + SINCE];
        copy(body, 0, since);
        copy(other, 1, since);
        if (since + exactPairs.until(two, 0, 1) <= Math.min(best, 1) && exactPairs.exact(two, 0, 1, until)) {
            keepIfEarlier(body, other, since, now);
        }
    }

    /** Puts a body where it is at the time that the crowd's present and this one make up. */
    private void copy(int body, int to, double now) {
        int at = 8 * body;
        boolean there = crowd.state[at + SINCE] == now && crowd.low[4 * body + SINCE_LOW] == crowd.nowLow;
        two.x[to] = there ? crowd.state[at + X] : crowd.x(body, now);
        two.y[to] = there ? crowd.state[at + Y] : crowd.y(body, now);
        two.vx[to] = crowd.state[at + VX];
        two.vy[to] = crowd.state[at + VY];
        two.radius[to] = crowd.state[at + RADIUS];
    }

    private void keepIfEarlier(int body, int other, double since, double now) {
        time.setSum(since, crowd.nowLow).add(until);
        double high = time.high();
        double low = time.low();
        if (high < now) {
            high = now;                                // by roundings only
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
