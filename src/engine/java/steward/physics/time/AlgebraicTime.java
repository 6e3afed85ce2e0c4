package steward.physics.time;

import steward.numerics.Dyadic;
import steward.physics.Arena;
import steward.physics.HalfPlane;
import steward.physics.Segment;
import steward.physics.Wall;

/*
 * All times of impact are of the form (p + q sqrt r) / s with numbers p, q, r, s that are sums of products of the
 * inputs, r >= 0 and s > 0:
 *
 *     two circles     a t^2 + 2 b t + c = 0      t = (-b - sqrt(b^2 - a c)) / a      of ExactCircles
 *     arena           the later root             t = (-b + sqrt(b^2 - a c)) / a, or -b / a if it is never inside
 *     half-plane      g - w t = 0                t = g / w
 *     segment         |k| - r L = w t            t = (|k| - r sqrt(L^2)) / w         k = (B - A) x (p - A)
 *
 * and a start of flight u is added as (p + u s). Two are compared by the sign of a + b sqrt x + c sqrt y: where the
 * signs of a and of the roots together differ, a^2 is compared with their square, in which one root is left.
 */

/** Exact time of an impact, a number of degree two: equality and order without rounding. Allocates. */
record AlgebraicTime(Dyadic p, Dyadic q, Dyadic r, Dyadic s) implements Comparable<AlgebraicTime> {

    private static final Dyadic ONE = Dyadic.of(1);

    /** The sum of two doubles. */
    static AlgebraicTime of(double high, double low) {
        return new AlgebraicTime(Dyadic.of(high).plus(Dyadic.of(low)), Dyadic.ZERO, Dyadic.ZERO, ONE);
    }

    /** This much later. */
    AlgebraicTime plus(double high, double low) {
        return new AlgebraicTime(p.plus(Dyadic.of(high).plus(Dyadic.of(low)).times(s)), q, r, s);
    }

    /** Two circles that approach, meet and do not touch yet: the time until they touch. */
    static AlgebraicTime ofPair(double x1, double x2, double y1, double y2, double vx1, double vx2, double vy1,
                                double vy2, double r1, double r2) {
        return root(Dyadic.difference(x1, x2), Dyadic.difference(y1, y2), Dyadic.difference(vx1, vx2),
            Dyadic.difference(vy1, vy2), Dyadic.difference(r1, -r2), false);
    }

    /** The time until |d + v t| = s; {@code null} for an earlier root that is not reached. */
    private static AlgebraicTime root(Dyadic dx, Dyadic dy, Dyadic vx, Dyadic vy, Dyadic s, boolean later) {
        Dyadic a = vx.square().plus(vy.square());
        Dyadic b = dx.times(vx).plus(dy.times(vy));
        Dyadic c = dx.square().plus(dy.square()).minus(s.square());
        Dyadic discriminant = b.square().minus(a.times(c));
        if (discriminant.signum() <= 0) {
            return later ? new AlgebraicTime(b.negate(), Dyadic.ZERO, Dyadic.ZERO, a) : null;
        }
        return later || b.signum() < 0
            ? new AlgebraicTime(b.negate(), later ? ONE : ONE.negate(), discriminant, a) : null;
    }

    /** A circle that approaches a wall, hits it and does not touch it yet: the time until it does. */
    static AlgebraicTime ofWall(Wall wall, double x, double y, double vx, double vy, double radius) {
        if (wall instanceof HalfPlane plane) {
            return ofPlane(plane, x, y, vx, vy, radius);
        }
        if (wall instanceof Arena arena) {
            return root(Dyadic.difference(x, arena.x()), Dyadic.difference(y, arena.y()), Dyadic.of(vx), Dyadic.of(vy),
                radius <= arena.radius() ? Dyadic.difference(arena.radius(), radius) : Dyadic.ZERO, true);
        }
        return ofSegment((Segment) wall, x, y, vx, vy, radius);
    }

    private static AlgebraicTime ofPlane(HalfPlane plane, double x, double y, double vx, double vy, double radius) {
        Dyadic insideX = Dyadic.of(plane.insideX());
        Dyadic insideY = Dyadic.of(plane.insideY());
        Dyadic gap = Dyadic.difference(x, plane.x()).times(insideX).plus(Dyadic.difference(y, plane.y()).times(insideY))
            .minus(Dyadic.of(radius));
        Dyadic closing = Dyadic.of(vx).times(insideX).plus(Dyadic.of(vy).times(insideY)).negate();
        return new AlgebraicTime(gap, Dyadic.ZERO, Dyadic.ZERO, closing);
    }

    /** The flat side if its foot is between the ends then; otherwise the end that is hit first. */
    private static AlgebraicTime ofSegment(Segment segment, double x, double y, double vx, double vy, double radius) {
        Dyadic bx = Dyadic.difference(segment.bx(), segment.ax());
        Dyadic by = Dyadic.difference(segment.by(), segment.ay());
        Dyadic px = Dyadic.difference(x, segment.ax());
        Dyadic py = Dyadic.difference(y, segment.ay());
        Dyadic vX = Dyadic.of(vx);
        Dyadic vY = Dyadic.of(vy);
        Dyadic r = Dyadic.of(radius);
        Dyadic cross = bx.times(py).minus(by.times(px));
        Dyadic closing = bx.times(vY).minus(by.times(vX));
        if (cross.signum() >= 0) {
            closing = closing.negate();
        } else {
            cross = cross.negate();
        }
        Dyadic squared = bx.square().plus(by.square());
        if (closing.signum() > 0) {
            Dyadic along = bx.times(vX).plus(by.times(vY));
            Dyadic foot = bx.times(px).plus(by.times(py)).times(closing).plus(along.times(cross));
            Dyadic root = along.times(r).negate();
            if (sign(foot, root, squared) >= 0 && sign(foot.minus(squared.times(closing)), root, squared) <= 0) {
                return new AlgebraicTime(cross, r.negate(), squared, closing);
            }
        }
        AlgebraicTime first = root(px, py, vX, vY, r, false);
        AlgebraicTime second = root(px.minus(bx), py.minus(by), vX, vY, r, false);
        return second == null || first != null && first.compareTo(second) <= 0 ? first : second;
    }

    @Override
    public int compareTo(AlgebraicTime other) {
        return sign(p.times(other.s).minus(other.p.times(s)), q.times(other.s), r,
            other.q.times(s).negate(), other.r);
    }

    /** The sign of a + b sqrt x. */
    private static int sign(Dyadic a, Dyadic b, Dyadic x) {
        int signA = a.signum();
        int signB = b.signum() * x.signum();
        return signA == 0 || signA == signB ? signB
            : signB == 0 ? signA : signA * a.square().minus(b.square().times(x)).signum();
    }

    /** The sign of a + b sqrt x + c sqrt y. */
    private static int sign(Dyadic a, Dyadic b, Dyadic x, Dyadic c, Dyadic y) {
        Dyadic bb = b.square().times(x);
        Dyadic cc = c.square().times(y);
        if (bb.signum() == 0 || cc.signum() == 0) {
            return bb.signum() == 0 ? sign(a, c, y) : sign(a, b, x);
        }
        int roots = b.signum() == c.signum() ? b.signum() : b.signum() * bb.minus(cc).signum();
        if (roots == 0 || a.signum() == 0 || a.signum() == roots) {
            return roots == 0 ? a.signum() : roots;
        }
        Dyadic twice = b.times(c).times(Dyadic.of(-2));
        return a.signum() * sign(a.square().minus(bb).minus(cc), twice, x.times(y));
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof AlgebraicTime time && compareTo(time) == 0;
    }

    @Override
    public int hashCode() {
        return 0;                                       // equal numbers have many forms, and nobody hashes them
    }
}
