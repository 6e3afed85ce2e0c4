package steward.lab.trial;

import steward.physics.Bodies;

/*
 * Products of doubles are kept exactly as p + e with p = fl(a b), e = fma(a, b, -p); sums by Knuth's two-sum. A sum of
 * n such terms has an error of about n 2^-105 of its largest partial sum.
 */

/**
 * Sum of the change of momentum of every impact, to check that momentum is conserved. The change is m (v after - v
 * before) from the stored velocities, in double-double arithmetic; the walls' share is what the bodies received from
 * them.
 */
public final class MomentumBalance extends Probe {

    private final double[] masses;
    private final Sum[] booked = {new Sum(), new Sum()};
    private final Sum[] start = {new Sum(), new Sum()};
    private double exchanged;

    public MomentumBalance(Bodies bodies) {
        masses = java.util.Arrays.copyOf(bodies.mass, bodies.size());
        total(bodies, start);
    }

    @Override
    public void impact(double time, int a, int b, double ax, double ay, double bx, double by, double nx, double ny,
                       double j, double energy, double massA, double massB, double vax, double vay, double vaxAfter,
                       double vayAfter, double vbx, double vby, double vbxAfter, double vbyAfter) {
        super.impact(time, a, b, ax, ay, bx, by, nx, ny, j, energy, massA, massB, vax, vay, vaxAfter, vayAfter, vbx,
            vby, vbxAfter, vbyAfter);
        exchanged += Math.abs(j);
        book(massA, vax, vay, vaxAfter, vayAfter);
        if (b >= 0) {
            book(massB, vbx, vby, vbxAfter, vbyAfter);
        }
    }

    private void book(double mass, double vx, double vy, double vxAfter, double vyAfter) {
        booked[0].addProduct(mass, vxAfter);
        booked[0].addProduct(-mass, vx);
        booked[1].addProduct(mass, vyAfter);
        booked[1].addProduct(-mass, vy);
    }

    private void total(Bodies bodies, Sum[] sums) {
        for (int k = 0; k < masses.length; k++) {
            sums[0].addProduct(masses[k], bodies.vx[k]);
            sums[1].addProduct(masses[k], bodies.vy[k]);
        }
    }

    /**
     * The bodies' momentum now, less that at the start, less the summed changes: as a share of all momentum exchanged.
     */
    public double gap(Bodies bodies) {
        Sum[] now = {new Sum(), new Sum()};
        total(bodies, now);
        double worst = 0;
        for (int axis = 0; axis < 2; axis++) {
            now[axis].subtract(start[axis]);
            now[axis].subtract(booked[axis]);
            worst = Math.max(worst, Math.abs(now[axis].high + now[axis].low));
        }
        return exchanged == 0 ? 0 : worst / exchanged;
    }

    /** A double-double sum. */
    private static final class Sum {

        private double high;
        private double low;

        void addProduct(double a, double b) {
            double product = a * b;
            add(product);
            low += Math.fma(a, b, -product);
        }

        void subtract(Sum other) {
            add(-other.high);
            add(-other.low);
        }

        private void add(double value) {
            double sum = high + value;
            double part = sum - high;
            double error = (high - (sum - part)) + (value - part);
            high = sum;
            low += error;
            double whole = high + low;
            low = low - (whole - high);
            high = whole;
        }
    }
}
