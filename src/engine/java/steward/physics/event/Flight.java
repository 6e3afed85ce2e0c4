package steward.physics.event;

import steward.numerics.DoubleDouble;
import steward.numerics.ErrorFree;
import steward.physics.Bodies;
import steward.physics.time.LowParts;

/*
 * x + v t with t = th + tl: p = RN(v th) and its error e are exact, s = RN(x + p) and its error f too; the rest,
 * f + (e + v tl), has roundings below 2^-104 |v t|. So s + rest is x + v t to within 2^-104 |v t| and the relative
 * error of t, and storing it rounds once: at most 0.51 ulp unless x and v t cancel by more than 2^40.
 */

/**
 * Free flight of all bodies from one impact to the next and to the end of the turn. Times are plain doubles or
 * double-doubles. With double-doubles each coordinate is rounded once, when it is stored; {@link LowParts} keeps its
 * rounding error.
 */
final class Flight {

    /** {@code null} in plain doubles. */
    private final ExactImpactQueue queue;
    private final LowParts low;
    private final DoubleDouble now = new DoubleDouble();
    private final DoubleDouble time = new DoubleDouble();
    /** True if low parts may differ from 0. */
    private boolean lowPartsSet;

    Flight(ExactImpactQueue queue, LowParts low) {
        this.queue = queue;
        this.low = low;
    }

    /** Begins a turn. @return its time, 0 */
    double begin(Bodies bodies) {
        if (queue != null) {
            low.ensureCapacity(bodies.capacity());
            queue.begin(bodies, now.set(0));
            lowPartsSet = true;
        }
        return 0;
    }

    /** Moves all bodies to the first impact of the batch that a queue has chosen. @return its time within the turn */
    double toImpact(Bodies bodies, double start, ImpactQueue chosen) {
        if (queue == null) {
            EventAdvance.fly(bodies, chosen.time(0) - start);
            return chosen.time(0);
        }
        queue.untilFirst(time);
        if (time.high() != 0) {
            lowPartsSet = true;
            fly(bodies);
        } else if (lowPartsSet) {
            low.clearFirst(bodies.size());
            lowPartsSet = false;
        }
        return now.add(time).high();
    }

    /** Moves all bodies to the end of the turn. */
    void toEnd(Bodies bodies, double start) {
        if (queue == null) {
            EventAdvance.fly(bodies, 1 - start);
        } else {
            time.setDifference(1, now.high()).add(-now.low());
            fly(bodies);
        }
    }

    private void fly(Bodies bodies) {
        fly(bodies.x, bodies.vx, low.x, bodies.size(), time.high(), time.low());
        fly(bodies.y, bodies.vy, low.y, bodies.size(), time.high(), time.low());
    }

    private static void fly(double[] x, double[] v, double[] low, int count, double timeHigh, double timeLow) {
        for (int i = 0; i < count; i++) {
            double path = v[i] * timeHigh;
            double sum = x[i] + path;
            double rest = ErrorFree.sumError(x[i], path, sum)
                + (ErrorFree.productError(v[i], timeHigh, path) + v[i] * timeLow);
            double stored = sum + rest;
            low[i] = ErrorFree.sumError(sum, rest, stored);
            x[i] = stored;
        }
    }
}
