package steward.physics.time;

import steward.numerics.DoubleDouble;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;

/*
 * The filter. All quantities are computed in plain doubles from differences that are rounded themselves. With
 * u = 2^-53 and each rounding a factor within 1 +- u:
 *
 *     b = dx vx + dy vy        2 differences, product, sum:      off by at most  5 u (|dx vx| + |dy vy|)
 *     c = dx^2 + dy^2 - s^2    the same, and a difference:                       8 u (dx^2 + dy^2 + s^2)
 *     c + 2 min(b, 0)          one more sum:                      one u of each term more than both together
 *     D = a s^2 - (d x v)^2    a s^2 by 9 u, (d x v)^2 by 9 u m^2:              16 u (a s^2 + m^2)
 *                              with m = |dx vy| + |dy vx|
 *
 * where the constants leave room for second orders and for computing the bounds themselves. A value larger than its
 * bound has its true sign. Underflow: b's bound has 2^-1000 more, and when a and s^2 are at least 2^-450 what
 * underflows next to them does not count. Overflow makes a bound infinite, which no value is above. So the decisions of
 * the filter are right, and what it leaves undecided is computed exactly.
 *
 * As a t^2 is never below 0, the squared distance less s^2 is at least c + 2 b t, and for b < 0 at least c + 2 b up to
 * t = 1: when that is above 0, the two do not meet within a turn, and no root is needed. Most pairs are decided here.
 *
 * Then t = c / (sqrt D - b) is off, relatively, by at most 8 u (...) / c from c, by the errors of sqrt D (at most 2
 * (error of D) / sqrt D when D is above its bound) and b over their sum, and 4 u; it is reduced by this much, and by
 * 2^-52 for the roundings when it is added to the time of the turn: a lower bound of the time of impact.
 */

/**
 * Times of impact of circles for the arithmetic {@code EXACT}: fast lower bounds for all pairs, with exact decisions,
 * and times in double-double. These are computed for pairs that may be next. Exact signs decide if two touch, approach
 * and meet; a tangent path is a miss.
 */
public final class ExactPairs extends PairTime {

    private static final double NEVER = Double.POSITIVE_INFINITY;
    private static final double U = 0x1p-53;
    private static final double TINY = 0x1p-1000;
    private static final double LEAST = 0x1p-450;
    /** Bound on the rounding error of the sum of two times within a turn. */
    public static final double ROUNDING = 0x1p-52;

    private final boolean separatingReact;
    private final ExactCircles circles = new ExactCircles();
    private final DoubleDouble time = new DoubleDouble();

    public ExactPairs(ImpactLaw law) {
        separatingReact = law.separatingPairsReact();
    }

    /**
     * @return a lower bound of the time, at least 0; infinite only if the two do not meet within the length of a turn
     */
    @Override
    public double until(Bodies bodies, int i, int j, double ri, double rj) {
        return lowerBound(bodies.x[i], bodies.x[j], bodies.y[i], bodies.y[j], bodies.vx[i], bodies.vx[j],
            bodies.vy[i], bodies.vy[j], ri, rj);
    }

    /** Lower bound of the time of two circles. */
    public double lowerBound(double x1, double x2, double y1, double y2, double vx1, double vx2, double vy1,
                             double vy2, double r1, double r2) {
        double dx = x1 - x2;
        double dy = y1 - y2;
        double dvx = vx1 - vx2;
        double dvy = vy1 - vy2;
        double xvx = dx * dvx;
        double yvy = dy * dvy;
        double b = xvx + yvy;
        double bError = 6 * U * (Math.abs(xvx) + Math.abs(yvy)) + TINY;
        if (!separatingReact && b > bError) {
            return NEVER;
        }
        double s = r1 + r2;
        double squared = dx * dx + dy * dy;
        double ss = s * s;
        double c = squared - ss;
        double cError = 10 * U * (squared + ss) + TINY;
        if (c < -cError && (separatingReact || b < -bError)) {
            return 0;
        }
        if (c + (b - Math.abs(b)) > cError + 2 * bError) {
            return NEVER;
        }
        double a = dvx * dvx + dvy * dvy;
        if (!(c > cError && Math.abs(b) > bError && a >= LEAST && ss >= LEAST)) {
            return undecided(x1, x2, y1, y2, vx1, vx2, vy1, vy2, r1, r2);
        }
        if (b > 0) {
            return NEVER;
        }
        double xvy = dx * dvy;
        double yvx = dy * dvx;
        double cross = xvy - yvx;
        double m = Math.abs(xvy) + Math.abs(yvx);
        double ass = a * ss;
        double discriminant = ass - cross * cross;
        double error = 16 * U * (ass + m * m);
        if (discriminant < -error) {
            return NEVER;
        }
        return discriminant > error ? boundOfMeeting(b, bError, c, cError, discriminant, error)
            : undecided(x1, x2, y1, y2, vx1, vx2, vy1, vy2, r1, r2);
    }

    private static double boundOfMeeting(double b, double bError, double c, double cError, double discriminant,
                                         double error) {
        double root = Math.sqrt(discriminant);
        double sum = root - b;
        double relative = (cError * root * sum + (2 * error + bError * root) * c) / (c * root * sum) + 4 * U;
        return relative < 1 ? Math.max(0, c / sum * (1 - relative) - ROUNDING) : 0;
    }

    private double undecided(double x1, double x2, double y1, double y2, double vx1, double vx2, double vy1,
                             double vy2, double r1, double r2) {
        boolean sliding = (x1 == x2 || vx1 == vx2) && (y1 == y2 || vy1 == vy2);
        if (sliding && !separatingReact) {
            return NEVER;                             // every term of b is exactly 0
        }
        boolean meet = exactTime(x1, x2, y1, y2, vx1, vx2, vy1, vy2, r1, r2, FastCircles.COARSE, time);
        return meet ? Math.max(0, time.high() * (1 - 4 * U) - ROUNDING) : NEVER;
    }

    /** The time of impact from now. @return false if there is none */
    public boolean exactTime(Bodies bodies, int i, int j, DoubleDouble until) {
        return exactTime(bodies.x[i], bodies.x[j], bodies.y[i], bodies.y[j], bodies.vx[i], bodies.vx[j],
            bodies.vy[i], bodies.vy[j], bodies.radius[i], bodies.radius[j], FastCircles.FINE, until);
    }

    /** The time of impact of two circles. @return false if there is none */
    public boolean exactTime(double x1, double x2, double y1, double y2, double vx1, double vx2, double vy1, double vy2,
                             double r1, double r2, DoubleDouble until) {
        return exactTime(x1, x2, y1, y2, vx1, vx2, vy1, vy2, r1, r2, FastCircles.FINE, until);
    }

    private boolean exactTime(double x1, double x2, double y1, double y2, double vx1, double vx2, double vy1,
                              double vy2, double r1, double r2, double grade, DoubleDouble until) {
        int quick = FastCircles.firstTouch(x1, x2, y1, y2, vx1, vx2, vy1, vy2, r1, r2, separatingReact, grade, until);
        if (quick != FastCircles.UNDECIDED) {
            return quick == FastCircles.IMPACT;
        }
        circles.load(x1, x2, y1, y2, vx1, vx2, vy1, vy2, r1, r2);
        if (separatingReact && circles.areTouching()) {
            until.set(0);
            return true;
        }
        return circles.firstTouch(until);
    }

    /** True if two bodies approach, by the exact sign of b. */
    public boolean areApproaching(Bodies bodies, int i, int j) {
        double xvx = (bodies.x[i] - bodies.x[j]) * (bodies.vx[i] - bodies.vx[j]);
        double yvy = (bodies.y[i] - bodies.y[j]) * (bodies.vy[i] - bodies.vy[j]);
        double bError = 6 * U * (Math.abs(xvx) + Math.abs(yvy)) + TINY;
        double b = xvx + yvy;
        return Math.abs(b) > bError ? b < 0 : circles.load(bodies, i, j).areApproaching();
    }
}
