package steward.physics.event;

import steward.numerics.DoubleDouble;
import steward.numerics.ErrorFree;
import steward.physics.Bodies;
import steward.physics.PhysicsParts;
import steward.physics.event.flight.PairSelection;
import steward.physics.time.ExactPairs;
import steward.physics.time.ExactWalls;

/**
 * Queue of impacts that are offered with lower bounds of their times. A time is computed in double-double only if its
 * bound is not out of the window of the earliest so far. An impact whose time is not in the turn is dropped. Times in
 * the queue are those from now.
 */
final class ExactImpactQueue extends ImpactQueue {

    private final ExactPairs pairs;
    private final ExactWalls walls;
    /** {@code null} if all can react. */
    private final PairSelection selection;
    private final DoubleDouble until = new DoubleDouble();
    private final DoubleDouble left = new DoubleDouble();
    private Bodies bodies;
    private DoubleDouble now;
    private double startHigh;
    private double startLow;

    ExactImpactQueue(PhysicsParts parts, ExactPairs pairs, ExactWalls walls) {
        super(parts.law());
        selection = PairSelection.of(parts);
        this.pairs = pairs;
        this.walls = walls;
    }

    /** Begins a turn with these bodies; the flight keeps the time of the turn in the register. */
    void begin(Bodies ofTurn, DoubleDouble timeOfTurn) {
        bodies = ofTurn;
        now = timeOfTurn;
    }

    @Override
    void clear() {
        super.clear();
        startHigh = now.high();
        startLow = now.low();
        left.setDifference(1, startHigh).add(-startLow);
    }

    @Override
    void offer(double bound, int a, int b) {
        if (mayBeNext(bound - startHigh - ExactPairs.ROUNDING)
            && (b < 0 ? walls.exactTime(bodies, a, ~b, until) : exactTime(a, b)) && until.compareTo(left) <= 0) {
            insert(until.high(), until.low(), a, b);
        }
    }

    private boolean exactTime(int a, int b) {
        return pairs.exactTime(bodies.x[a], bodies.x[b], bodies.y[a], bodies.y[b], bodies.vx[a], bodies.vx[b],
            bodies.vy[a], bodies.vy[b], PairSelection.radius(selection, bodies, a, b),
            PairSelection.radius(selection, bodies, b, a), until);
    }

    /** The time from now to the first impact. */
    void untilFirst(DoubleDouble result) {
        result.setFastSum(super.time(0), low(0));
    }

    @Override
    double time(int k) {
        double high = super.time(k);
        double sum = startHigh + high;
        return sum + (ErrorFree.sumError(startHigh, high, sum) + (startLow + low(k)));
    }
}
