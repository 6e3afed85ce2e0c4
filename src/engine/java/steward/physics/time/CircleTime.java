package steward.physics.time;

import steward.physics.Arithmetic;

/*
 * One quadratic. With d the vector from one centre to the other, v its velocity and s the touching distance,
 *
 *     |d + v t| = s    <=>    a t^2 + 2 b t + c = 0,    a = v.v,  b = d.v,  c = d.d - s^2,  D = b^2 - a c.
 *
 * They approach when b < 0; the first touch is then the smaller root (-b - sqrt D) / a. Both of its differences cancel:
 * -b - sqrt D when c is small against the rest (a touch soon), and b^2 - a c when the path grazes or starts far away.
 * Multiplying by (-b + sqrt D) gives the same root as c / (-b + sqrt D), a sum of positive terms; with c = (|d| - s)
 * (|d| + s) nothing is lost to squaring; and by Lagrange's identity b^2 = a d.d - (d x v)^2, so
 *
 *     D = a s^2 - (d x v)^2 = (|v| s - |d x v|)(|v| s + |d x v|),
 *
 * in which the distance no longer appears: only s against the impact parameter p = |d x v| / |v|. There remain the two
 * differences on which the decision itself depends, |d| - s and |v| s - |d x v|: close to contact and to a grazing path
 * they are only as accurate as their terms.
 *
 * The members, with u = 2^-53 and cos that of the angle between v and the normal at the touch:
 *
 *     member              differences  decision right unless               time of impact
 *     official            rounded      |p^2 - s^2| <= 16 u d.d             16 u d.d / s |v| cos, and bits of the server
 *     stable              rounded      |p - s| or |d| - s <= 8 u |d|       16 u |d| / |v| cos
 *     CompensatedCircles  two doubles  the same, 2^-46 in place of 8 u     5 units in the last place
 *     FastCircles         two doubles  always; undecided if not clear      2^-62, relative
 *     ExactCircles        two doubles  always                              2^-62, relative
 *     WideCircles         decimals     always                              50 digits
 *
 * The reject. As a t^2 is never below 0, |d + v t|^2 - s^2 is at least c + 2 min(b, 0) up to t = 1. A pair is left out
 * if that, as computed, is above m = 2^-40 (d.d + s^2), and then every member finds no impact within the turn. Computed
 * c is off by at most 2^-49 d.d, computed b by e = 2^-51 |d| |v|; both are far below m unless |v| > 2^8 |d|.
 *
 * (1) |v| > 2^8 |d|. |b| <= c / 2 + e gives b^2 / a <= c^2 / (2 a) + 2 e^2 / a <= c 2^-17 + 2^-101 d.d < c / 2, as c
 *     is above 2^-40 d.d. So D <= -a c / 2 < -2^-41 a d.d; its error is below 2^-48 a d.d in each member: a miss.
 * (2) |v| <= 2^8 |d|. 2 e is at most m / 4, so truly c + 2 min(b, 0) > m / 2. Where |b| <= e, b^2 is far below a c: a
 *     miss. Where b < -e, D is less than b^2 by a c >= 2^-40 a d.d, which is above its error: the computed sqrt D is at
 *     most |b|, and c / (sqrt D - b) at least (2 |b| + m / 4) / (2 |b| + 2 e) > 1. For the root of the official
 *     expressions see FarPairs, (2), where the margin is the same share of d.d.
 */

/** Time of impact of two circles, in one arithmetic: a family of solutions of one quadratic. */
public abstract sealed class CircleTime permits CircleTime.Official, CircleTime.Stable, CompensatedCircles {

    static final double NEVER = Double.POSITIVE_INFINITY;

    /**
     * Relative to the square of the touching distance: 32 roundings, while the official root is accurate to about
     * three.
     */
    private static final double ROUNDING = 0x1p-48;
    /** The margin of the reject, relative to the squared distances. */
    private static final double MARGIN = 0x1p-40;

    /** @return an instance for one thread at a time; {@code null} for {@code EXACT}, see {@link ExactPairs} */
    public static CircleTime of(Arithmetic arithmetic) {
        return switch (arithmetic) {
            case OFFICIAL -> new Official();
            case DOUBLE -> new Stable();
            case COMPENSATED -> new CompensatedCircles();
            case EXACT -> null;
        };
    }

    /**
     * Time until the impact of two circles.
     *
     * @param separatingReact whether they react when they touch even if they do not approach
     * @return 0 for an impact now
     */
    public double until(double x1, double x2, double y1, double y2, double vx1, double vx2, double vy1, double vy2,
                        double r1, double r2, boolean separatingReact) {
        double dx = x1 - x2;
        double dy = y1 - y2;
        double dvx = vx1 - vx2;
        double dvy = vy1 - vy2;
        if (!separatingReact && !(dx * dvx + dy * dvy < 0)) {
            return NEVER;
        }
        double touch = r1 + r2;
        if (Math.sqrt(dx * dx + dy * dy) <= touch) {
            return 0;
        }
        return separatingReact ? until(dx, dy, dvx, dvy, touch) : untilApproachingMeet(dx, dy, dvx, dvy, touch);
    }

    /**
     * As {@link #until} where only approach reacts, but never for an impact after the end of the turn.
     *
     * @param start the time of the turn at which the circles are where they are
     */
    public double untilInTurn(double x1, double x2, double y1, double y2, double vx1, double vx2, double vy1,
                              double vy2, double r1, double r2, double start) {
        double until = until(x1, x2, y1, y2, vx1, vx2, vy1, vy2, r1, r2, false);
        return until <= 1 - start ? until : NEVER;
    }

    /** Time until two circles touch that do not touch now; see {@link TimeOfImpact}. */
    abstract double until(double dx, double dy, double dvx, double dvy, double touch);

    /**
     * Time until two circles touch under a law in which only approach reacts: an approaching pair that touches except
     * for rounding errors must not be missed.
     */
    double untilApproachingMeet(double dx, double dy, double dvx, double dvy, double touch) {
        return until(dx, dy, dvx, dvy, touch);
    }

    /** True if two circles surely do not touch within a turn: most pairs, without a root or a division. */
    static boolean areFar(double dx, double dy, double dvx, double dvy, double touch) {
        double squared = dx * dx + dy * dy;
        double ss = touch * touch;
        double b = dx * dvx + dy * dvy;
        return squared - ss - MARGIN * (squared + ss) + (b - Math.abs(b)) > 0;
    }

    /**
     * Circle and circle, in the form without avoidable cancellation.
     *
     * @param dx    from the centre of one to the centre of the other
     * @param dvx   velocity of the other relative to the one
     * @param touch the sum of the radii
     */
    static double stable(double dx, double dy, double dvx, double dvy, double touch) {
        double b = dx * dvx + dy * dvy;
        if (!(b < 0)) {
            return NEVER;
        }
        double distance = Math.sqrt(dx * dx + dy * dy);
        double c = (distance - touch) * (distance + touch);
        if (c <= 0) {
            return 0;
        }
        double speed = Math.sqrt(dvx * dvx + dvy * dvy);
        double offset = Math.abs(dx * dvy - dy * dvx);
        double discriminant = (speed * touch - offset) * (speed * touch + offset);
        return discriminant > 0 ? c / (Math.sqrt(discriminant) - b) : NEVER;
    }

    /**
     * Circle and circle, with the expressions of the published official referee in their order, including their
     * cancellation, for two circles that do not touch now. It takes the lesser of two quotients: that is the second,
     * because a > 0. Negating both vectors does not change a bit of the result.
     *
     * @param c the square of the distance less that of the touching distance
     * @return above 0, or {@code POSITIVE_INFINITY}
     */
    public static double official(double dx, double dy, double dvx, double dvy, double c) {
        double a = dvx * dvx + dvy * dvy;
        double b = dx * dvx + dy * dvy;
        double discriminant = b * b - a * c;
        if (!(discriminant > 0) || a == 0) {
            return NEVER;
        }
        double root = (-b - Math.sqrt(discriminant)) / a;
        return root > 0 ? root : NEVER;
    }

    /** {@link #official}. */
    static final class Official extends CircleTime {

        @Override
        double until(double dx, double dy, double dvx, double dvy, double touch) {
            return official(dx, dy, dvx, dvy, dx * dx + dy * dy - touch * touch);
        }

        /**
         * Close to contact the official roots consist of rounding errors, and a root that is not above 0 counts as a
         * miss.
         */
        @Override
        double untilApproachingMeet(double dx, double dy, double dvx, double dvy, double touch) {
            double c = dx * dx + dy * dy - touch * touch;
            return c <= ROUNDING * touch * touch ? 0 : official(dx, dy, dvx, dvy, c);
        }
    }

    /** {@link #stable}. */
    static final class Stable extends CircleTime {

        @Override
        double until(double dx, double dy, double dvx, double dvy, double touch) {
            return stable(dx, dy, dvx, dvy, touch);
        }
    }
}
