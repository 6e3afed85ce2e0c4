package steward.physics.time;

import steward.numerics.DoubleDouble;
import steward.numerics.Expansion;
import steward.physics.Bodies;

/*
 * The values of CircleTime. The differences d and v of two doubles and the sum s of two are exactly two doubles each;
 * CircleSums says how accurate sums of products of these are. Where 36 bits or more cancel, the exact expansion
 * replaces them: so signs are right, and relative errors are below 40 * 2^-106 * 2^36 < 2^-64.
 *
 * d x v itself can cancel, when the flight is almost central; then its square is small against a s^2, and the errors of
 * the products are relative to (|dx vy| + |dy vx|)^2. D is compared with this magnitude.
 *
 * The roots c / (sqrt D - b) for b < 0, and -c / (sqrt D + b) or (sqrt D - b) / a, only add terms of one sign, square
 * roots and divisions: together below 2^-62, after which a result is rounded once, to at most 0.5 + 2^-9 ulp.
 */

/**
 * Times at which two circles touch, with exact decisions and in double-double. Call {@code load}, then the queries. One
 * instance serves one thread; it allocates only for numbers so far apart (more than about 2^400 between the largest and
 * the smallest) that no power of two brings their products into the range of doubles: then {@link WideCircles}
 * computes.
 */
final class ExactCircles {

    private static final double CANCELLED = 0x1p-36;
    /** Powers up to the fourth of numbers from here on, with all their digits, are in the range of doubles. */
    private static final double SMALLEST = 0x1p-210;
    private static final double LARGEST = 0x1p210;

    private final DoubleDouble dx = new DoubleDouble();
    private final DoubleDouble dy = new DoubleDouble();
    private final DoubleDouble vx = new DoubleDouble();
    private final DoubleDouble vy = new DoubleDouble();
    private final DoubleDouble s = new DoubleDouble();
    private final DoubleDouble a = new DoubleDouble();
    private final DoubleDouble b = new DoubleDouble();
    private final DoubleDouble c = new DoubleDouble();
    private final DoubleDouble discriminant = new DoubleDouble();
    private final DoubleDouble work = new DoubleDouble();
    private final Expansion sum = new Expansion();
    private final Expansion squares = new Expansion();
    private final Expansion others = new Expansion();
    private int timeScale;
    private WideCircles wide;

    /** Two bodies, by their indices. */
    ExactCircles load(Bodies bodies, int i, int j) {
        return load(bodies.x[i], bodies.x[j], bodies.y[i], bodies.y[j], bodies.vx[i], bodies.vx[j],
            bodies.vy[i], bodies.vy[j], bodies.radius[i], bodies.radius[j]);
    }

    /** d = (x1 - x2, y1 - y2), v = (vx1 - vx2, vy1 - vy2), s = r1 + r2, all exactly; s is at least 0. */
    ExactCircles load(double x1, double x2, double y1, double y2, double vx1, double vx2, double vy1, double vy2,
                      double r1, double r2) {
        dx.setDifference(x1, x2);
        dy.setDifference(y1, y2);
        vx.setDifference(vx1, vx2);
        vy.setDifference(vy1, vy2);
        s.setSum(r1, r2);
        timeScale = 0;
        wide = null;
        if (!(fits(dx) && fits(dy) && fits(vx) && fits(vy) && fits(s)) && !scale()) {
            wide = new WideCircles(x1, x2, y1, y2, vx1, vx2, vy1, vy2, r1, r2);
            b.set(wide.approachSign());
            c.set(wide.touchSign());
            return this;
        }
        computeB();
        computeC();
        return this;
    }

    private static boolean fits(DoubleDouble value) {
        return fits(value.high()) && fits(value.low());
    }

    private static boolean fits(double value) {
        double size = Math.abs(value);
        return size == 0 || size >= SMALLEST && size <= LARGEST;
    }

    /**
     * Scales lengths and speeds by powers of two that bring the largest of each near 1.
     *
     * @return whether all then fit
     */
    private boolean scale() {
        double length = Math.max(Math.max(Math.abs(dx.high()), Math.abs(dy.high())), s.high());
        double speed = Math.max(Math.abs(vx.high()), Math.abs(vy.high()));
        if (!(length < Double.POSITIVE_INFINITY && speed < Double.POSITIVE_INFINITY)) {
            return false;
        }
        int byLength = length == 0 ? 0 : -Math.getExponent(length);
        int bySpeed = speed == 0 ? 0 : -Math.getExponent(speed);
        timeScale = bySpeed - byLength;
        return scale(dx, byLength) && scale(dy, byLength) && scale(s, byLength)
            && scale(vx, bySpeed) && scale(vy, bySpeed);
    }

    private static boolean scale(DoubleDouble value, int by) {
        double high = value.high();
        double low = value.low();
        value.scale(by);
        return Math.scalb(value.high(), -by) == high && Math.scalb(value.low(), -by) == low && fits(value);
    }

    private void computeB() {
        double xvx = dx.high() * vx.high();
        double yvy = dy.high() * vy.high();
        double rounded = xvx + yvy;
        b.setFastSum(rounded, CircleSums.dot(dx.high(), dx.low(), vx.high(), vx.low(), dy.high(), dy.low(), vy.high(),
            vy.low(), xvx, yvy, rounded));
        if (Math.abs(rounded) <= CANCELLED * (Math.abs(xvx) + Math.abs(yvy))) {
            sum.clear().addProduct(dx, vx).addProduct(dy, vy).roundTo(b);
        }
    }

    private void computeC() {
        double xx = dx.high() * dx.high();
        double yy = dy.high() * dy.high();
        double ss = s.high() * s.high();
        double squared = xx + yy;
        double rounded = squared - ss;
        c.setFastSum(rounded, CircleSums.excess(dx.high(), dx.low(), dy.high(), dy.low(), s.high(), s.low(), xx, yy, ss,
            squared, rounded));
        if (Math.abs(rounded) <= CANCELLED * (squared + ss)) {
            sum.clear().addProduct(dx, dx).addProduct(dy, dy).subtractProduct(s, s).roundTo(c);
        }
    }

    private void computeA() {
        double xx = vx.high() * vx.high();
        double yy = vy.high() * vy.high();
        double rounded = xx + yy;
        a.setFastSum(rounded, CircleSums.squares(vx.high(), vx.low(), vy.high(), vy.low(), xx, yy, rounded));
    }

    /** d x v, and the largest magnitude of its terms. */
    private double computeCross() {
        double xvy = dx.high() * vy.high();
        double yvx = dy.high() * vx.high();
        double rounded = xvy - yvx;
        work.setSum(rounded, CircleSums.cross(dx.high(), dx.low(), vy.high(), vy.low(), dy.high(), dy.low(), vx.high(),
            vx.low(), xvy, yvx, rounded));
        return Math.abs(xvy) + Math.abs(yvx);
    }

    private void computeDiscriminant() {
        computeA();
        double size = computeCross();
        double cross = work.high();
        double crossSquared = cross * cross;
        double ss = s.high() * s.high();
        double ass = a.high() * ss;
        double rounded = ass - crossSquared;
        discriminant.setFastSum(rounded, CircleSums.discriminant(a.high(), a.low(), ss,
            CircleSums.square(s.high(), s.low(), ss), cross, work.low(), ass, crossSquared, rounded));
        if (Math.abs(rounded) <= CANCELLED * (size * size + ass)) {
            squares.clear().addProduct(vx, vx).addProduct(vy, vy);
            others.clear().addProduct(s, s);
            sum.clear().addProduct(squares, others);
            squares.clear().addProduct(dx, vy).subtractProduct(dy, vx);
            sum.subtractProduct(squares, squares).roundTo(discriminant);
        }
    }

    /** True if the two touch or overlap: c <= 0. */
    boolean areTouching() {
        return c.high() <= 0;
    }

    /** True if the two approach: b < 0. */
    boolean areApproaching() {
        return b.high() < 0;
    }

    /** True if the two move apart: b > 0. */
    boolean areSeparating() {
        return b.high() > 0;
    }

    /**
     * The time at which an approaching pair first touches, 0 if it touches already; a tangent path is a miss.
     *
     * @return whether there is such a time
     */
    boolean firstTouch(DoubleDouble time) {
        if (!areApproaching()) {
            return false;
        }
        if (areTouching()) {
            time.set(0);
            return true;
        }
        if (wide != null) {
            return wide.firstTouch(time);
        }
        computeDiscriminant();
        if (discriminant.high() <= 0) {
            return false;
        }
        time.set(c).divide(discriminant.squareRoot().subtract(b));
        return unscale(time);
    }

    /**
     * The time at which a point inside the circle of radius s leaves it. From outside, the time at which it leaves
     * after having entered, or, if it never enters, the time of closest approach. 0 if it is at the edge or outside and
     * moves outward.
     *
     * @return false if the point does not move
     */
    boolean lastTouch(DoubleDouble time) {
        if (vx.high() == 0 && vy.high() == 0) {
            return false;
        }
        if (c.high() >= 0 && b.high() > 0) {
            time.set(0);
            return true;
        }
        if (wide != null) {
            return wide.lastTouch(time);
        }
        computeDiscriminant();
        if (discriminant.high() <= 0) {
            time.set(b).negate().divide(a);
        } else if (b.high() <= 0) {
            time.set(discriminant.squareRoot().subtract(b)).divide(a);
        } else {
            time.set(c).negate().divide(discriminant.squareRoot().add(b));
        }
        return unscale(time);
    }

    /**
     * Undoes the scaling: speeds times 2^p and lengths times 2^q multiply the time by 2^(q - p).
     *
     * @return whether it is finite
     */
    private boolean unscale(DoubleDouble time) {
        if (timeScale != 0) {
            time.scale(timeScale);
        }
        return time.high() < Double.POSITIVE_INFINITY;
    }
}
