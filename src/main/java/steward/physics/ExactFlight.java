package steward.physics;

import java.util.Arrays;
import steward.numerics.DoubleDouble;
import steward.numerics.ErrorFree;

/*
 * x + v t with t = th + tl: p = RN(v th) and its error e are exact, s = RN(x + p) and its error f too; what is left,
 * f + (e + v tl), has roundings below 2^-104 |v t|. So s + rest is x + v t to within 2^-104 |v t| and the relative
 * error of t, and storing it rounds once: at most 0.51 ulp unless x and v t cancel by more than 2^40.
 */

/**
 * Flies to times in double-double and rounds each coordinate once, when it is stored. What a coordinate has lost by
 * this is kept until the bodies fly on, so that an impact can be computed from where they really are.
 */
final class ExactFlight extends Flight {

    private final RefiningQueue queue;
    private final DoubleDouble now = new DoubleDouble();
    private final DoubleDouble time = new DoubleDouble();
    /** Whether the lows can be other than 0. */
    private boolean rounded;
    private double[] lowX = new double[0];
    private double[] lowY = new double[0];

    ExactFlight(RefiningQueue queue) {
        this.queue = queue;
    }

    /** Flies nobody, but keeps what coordinates have lost for somebody else who does. */
    ExactFlight() {
        this(null);
    }

    /** Room for so many bodies. */
    void room(int capacity) {
        if (lowX.length < capacity) {
            lowX = new double[capacity];
            lowY = new double[capacity];
        }
    }

    /** Somebody else has flown a body. */
    void set(int i, double ofX, double ofY) {
        lowX[i] = ofX;
        lowY[i] = ofY;
    }

    @Override
    double begin(Bodies bodies) {
        room(bodies.capacity());
        queue.begin(bodies, now.set(0));
        rounded = true;
        return 0;
    }

    @Override
    double toImpact(Bodies bodies, double start, ImpactQueue chosen) {
        queue.until(0, time);
        if (time.high() == 0) {
            forgetLows(bodies.size());
        } else {
            rounded = true;
            fly(bodies.x, bodies.vx, lowX, bodies.size(), time.high(), time.low());
            fly(bodies.y, bodies.vy, lowY, bodies.size(), time.high(), time.low());
        }
        return now.add(time).high();
    }

    private void forgetLows(int size) {
        if (rounded) {
            Arrays.fill(lowX, 0, size, 0);
            Arrays.fill(lowY, 0, size, 0);
            rounded = false;
        }
    }

    @Override
    void toEnd(Bodies bodies, double start) {
        time.setDifference(1, now.high()).add(-now.low());
        fly(bodies.x, bodies.vx, lowX, bodies.size(), time.high(), time.low());
        fly(bodies.y, bodies.vy, lowY, bodies.size(), time.high(), time.low());
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

    /** What the stored coordinate of a body lacks, as long as nobody has moved it. */
    double lowX(int i) {
        return lowX[i];
    }

    double lowY(int i) {
        return lowY[i];
    }

    /** Somebody has moved the body: where it is stored is where it is. */
    void moved(int i) {
        lowX[i] = 0;
        lowY[i] = 0;
    }
}
