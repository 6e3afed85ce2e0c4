package steward.physics.impulse;

import steward.numerics.DoubleDouble;
import steward.numerics.Expansion;
import steward.physics.Bodies;
import steward.physics.time.CircleSums;

/*
 * With v = va - vb, d from a to b and k = (1 + e) mb / (ma + mb), the velocity after an impact is
 *
 *     va' = va - k (v.d / d.d) d.
 *
 * In a nearly central impact nearly all of v changes, and what is left of va is a difference of nearly equal numbers:
 * for equal masses and e = 1 it can be nothing, and the roundings of v.d / d.d, some 2^-105 of v, would be left in its
 * place. But the part of v along d is v less the part across d,
 *
 *     (v.d / d.d) d = v - t,    t = (vx dy - vy dx) / d.d (dy, -dx),
 *
 * so va' = (1 - k) va + k (vb + t), 1 - k = (ma - e mb) / (ma + mb), in which nothing cancels but what cancels in the
 * result: for equal masses and e = 1, va' = vb + t, and t is exactly 0 in a central impact.
 */

/**
 * Velocities after an impact in which the two bodies move more along the line of centres than across it. They are
 * computed from the part of the relative velocity that the impulse does not change. Every number is two doubles,
 * rounded once.
 */
final class CentralImpact {

    private static final double CANCELLED = 0x1p-36;

    private final DoubleDouble vx = new DoubleDouble();
    private final DoubleDouble vy = new DoubleDouble();
    private final DoubleDouble dx = new DoubleDouble();
    private final DoubleDouble dy = new DoubleDouble();
    private final DoubleDouble cross = new DoubleDouble();
    private final DoubleDouble squared = new DoubleDouble();
    private final DoubleDouble acrossX = new DoubleDouble();
    private final DoubleDouble acrossY = new DoubleDouble();
    private final DoubleDouble kept = new DoubleDouble();
    private final DoubleDouble taken = new DoubleDouble();
    private final DoubleDouble work = new DoubleDouble();
    private final DoubleDouble other = new DoubleDouble();
    private final Expansion sum = new Expansion();

    /** Sets the vector from a to b. */
    CentralImpact direction(double x, double xLow, double y, double yLow) {
        dx.setFastSum(x, xLow);
        dy.setFastSum(y, yLow);
        return this;
    }

    /** Sets the square of its length. */
    CentralImpact squared(double high, double low) {
        squared.setFastSum(high, low);
        return this;
    }

    /** True if the two move at least as much along the line of centres, {@code along} times its length, as across. */
    boolean isCentral(double vax, double vbx, double vay, double vby, double along) {
        vx.setDifference(vax, vbx);
        vy.setDifference(vay, vby);
        double xvy = vx.high() * dy.high();
        double yvx = vy.high() * dx.high();
        if (!(Math.abs(xvy - yvx) <= Math.abs(along))) {
            return false;
        }
        computeCross(xvy, yvx);
        acrossX.set(cross).multiply(dy).divide(squared);
        acrossY.set(cross).multiply(dx).divide(squared).negate();
        return true;
    }

    /** vx dy - vy dx: an exact 0 where it is 0. */
    private void computeCross(double xvy, double yvx) {
        double rounded = xvy - yvx;
        if (Math.abs(rounded) <= CANCELLED * (Math.abs(xvy) + Math.abs(yvx))) {
            sum.clear().addProduct(vx, dy).subtractProduct(vy, dx).roundTo(cross);
            return;
        }
        cross.setSum(rounded, CircleSums.cross(vx.high(), vx.low(), dy.high(), dy.low(), vy.high(), vy.low(), dx.high(),
            dx.low(), xvy, yvx, rounded));
    }

    /** Stores the velocities after the impact; {@link #isCentral} has been asked. */
    void apply(Bodies bodies, int a, int b, double restitution) {
        double vax = bodies.vx[a];
        double vay = bodies.vy[a];
        double vbx = bodies.vx[b];
        double vby = bodies.vy[b];
        computeShares(bodies.mass[a], bodies.mass[b], restitution);
        bodies.vx[a] = combined(vax, vbx, acrossX);
        bodies.vy[a] = combined(vay, vby, acrossY);
        acrossX.negate();
        acrossY.negate();
        computeShares(bodies.mass[b], bodies.mass[a], restitution);
        bodies.vx[b] = combined(vbx, vax, acrossX);
        bodies.vy[b] = combined(vby, vay, acrossY);
    }

    /**
     * The share of its own velocity that a mass keeps, (m - e m2) / (m + m2), and that of the other's which it takes.
     */
    private void computeShares(double mass, double otherMass, double e) {
        if (mass == otherMass) {
            kept.setDifference(1, e).multiply(0.5);
            taken.setSum(1, e).multiply(0.5);
        } else if (mass == Double.POSITIVE_INFINITY) {
            kept.set(1);
            taken.set(0);
        } else if (otherMass == Double.POSITIVE_INFINITY) {
            kept.set(-e);
            taken.setSum(1, e);
        } else {
            work.setSum(mass, otherMass);
            other.setProduct(e, otherMass);
            kept.set(mass).subtract(other).divide(work);
            taken.set(otherMass).add(other).divide(work);
        }
    }

    private double combined(double own, double others, DoubleDouble across) {
        return other.set(across).add(others).multiply(taken).add(work.set(kept).multiply(own)).high();
    }
}
