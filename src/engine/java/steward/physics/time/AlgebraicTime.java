package steward.physics.time;

import java.math.BigDecimal;
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

/** Exact time of an impact as an algebraic number of degree two: equality and order without rounding. Allocates. */
record AlgebraicTime(BigDecimal p, BigDecimal q, BigDecimal r, BigDecimal s) implements Comparable<AlgebraicTime> {

    private static BigDecimal difference(double from, double what) {
        return new BigDecimal(from).subtract(new BigDecimal(what));
    }

    /** The sum of two doubles. */
    static AlgebraicTime of(double high, double low) {
        return new AlgebraicTime(new BigDecimal(high).add(new BigDecimal(low)), BigDecimal.ZERO, BigDecimal.ZERO,
            BigDecimal.ONE);
    }

    /** This much later. */
    AlgebraicTime plus(double high, double low) {
        return new AlgebraicTime(p.add(new BigDecimal(high).add(new BigDecimal(low)).multiply(s)), q, r, s);
    }

    /** Two circles that approach, meet and do not touch yet: the time until they touch. */
    static AlgebraicTime ofPair(double x1, double x2, double y1, double y2, double vx1, double vx2, double vy1,
                                double vy2, double r1, double r2) {
        return root(difference(x1, x2), difference(y1, y2), difference(vx1, vx2),
            difference(vy1, vy2), difference(r1, -r2), false);
    }

    /** The time until |d + v t| = s; {@code null} for an earlier root that is not reached. */
    private static AlgebraicTime root(BigDecimal dx, BigDecimal dy, BigDecimal vx, BigDecimal vy, BigDecimal s,
                                      boolean later) {
        BigDecimal a = vx.pow(2).add(vy.pow(2));
        BigDecimal b = dx.multiply(vx).add(dy.multiply(vy));
        BigDecimal c = dx.pow(2).add(dy.pow(2)).subtract(s.pow(2));
        BigDecimal discriminant = b.pow(2).subtract(a.multiply(c));
        if (discriminant.signum() <= 0) {
            return later ? new AlgebraicTime(b.negate(), BigDecimal.ZERO, BigDecimal.ZERO, a) : null;
        }
        return later || b.signum() < 0
            ? new AlgebraicTime(b.negate(), later ? BigDecimal.ONE : BigDecimal.ONE.negate(), discriminant, a) : null;
    }

    /** A circle that approaches a wall, hits it and does not touch it yet: the time until it does. */
    static AlgebraicTime ofWall(Wall wall, double x, double y, double vx, double vy, double radius) {
        if (wall instanceof HalfPlane plane) {
            return ofPlane(plane, x, y, vx, vy, radius);
        }
        if (wall instanceof Arena arena) {
            return root(difference(x, arena.x()), difference(y, arena.y()), new BigDecimal(vx), new BigDecimal(vy),
                radius <= arena.radius() ? difference(arena.radius(), radius) : BigDecimal.ZERO, true);
        }
        return ofSegment((Segment) wall, x, y, vx, vy, radius);
    }

    private static AlgebraicTime ofPlane(HalfPlane plane, double x, double y, double vx, double vy, double radius) {
        BigDecimal insideX = new BigDecimal(plane.insideX());
        BigDecimal insideY = new BigDecimal(plane.insideY());
        BigDecimal gap = difference(x, plane.x()).multiply(insideX).add(difference(y, plane.y()).multiply(insideY))
            .subtract(new BigDecimal(radius));
        BigDecimal closing = new BigDecimal(vx).multiply(insideX).add(new BigDecimal(vy).multiply(insideY)).negate();
        return new AlgebraicTime(gap, BigDecimal.ZERO, BigDecimal.ZERO, closing);
    }

    /** The flat side if its foot is between the ends then; otherwise the end that is hit first. */
    private static AlgebraicTime ofSegment(Segment segment, double x, double y, double vx, double vy, double radius) {
        BigDecimal bx = difference(segment.bx(), segment.ax());
        BigDecimal by = difference(segment.by(), segment.ay());
        BigDecimal px = difference(x, segment.ax());
        BigDecimal py = difference(y, segment.ay());
        BigDecimal vX = new BigDecimal(vx);
        BigDecimal vY = new BigDecimal(vy);
        BigDecimal r = new BigDecimal(radius);
        BigDecimal cross = bx.multiply(py).subtract(by.multiply(px));
        BigDecimal closing = bx.multiply(vY).subtract(by.multiply(vX));
        if (cross.signum() >= 0) {
            closing = closing.negate();
        } else {
            cross = cross.negate();
        }
        BigDecimal squared = bx.pow(2).add(by.pow(2));
        if (closing.signum() > 0) {
            BigDecimal along = bx.multiply(vX).add(by.multiply(vY));
            BigDecimal foot = bx.multiply(px).add(by.multiply(py)).multiply(closing).add(along.multiply(cross));
            BigDecimal root = along.multiply(r).negate();
            if (sign(foot, root, squared) >= 0 && sign(foot.subtract(squared.multiply(closing)), root, squared) <= 0) {
                return new AlgebraicTime(cross, r.negate(), squared, closing);
            }
        }
        AlgebraicTime first = root(px, py, vX, vY, r, false);
        AlgebraicTime second = root(px.subtract(bx), py.subtract(by), vX, vY, r, false);
        return second == null || first != null && first.compareTo(second) <= 0 ? first : second;
    }

    @Override
    public int compareTo(AlgebraicTime other) {
        return sign(p.multiply(other.s).subtract(other.p.multiply(s)), q.multiply(other.s), r,
            other.q.multiply(s).negate(), other.r);
    }

    /** The sign of a + b sqrt x. */
    private static int sign(BigDecimal a, BigDecimal b, BigDecimal x) {
        int signA = a.signum();
        int signB = b.signum() * x.signum();
        return signA == 0 || signA == signB ? signB
            : signB == 0 ? signA : signA * a.pow(2).subtract(b.pow(2).multiply(x)).signum();
    }

    /** The sign of a + b sqrt x + c sqrt y. */
    private static int sign(BigDecimal a, BigDecimal b, BigDecimal x, BigDecimal c, BigDecimal y) {
        BigDecimal bb = b.pow(2).multiply(x);
        BigDecimal cc = c.pow(2).multiply(y);
        if (bb.signum() == 0 || cc.signum() == 0) {
            return bb.signum() == 0 ? sign(a, c, y) : sign(a, b, x);
        }
        int roots = b.signum() == c.signum() ? b.signum() : b.signum() * bb.subtract(cc).signum();
        if (roots == 0 || a.signum() == 0 || a.signum() == roots) {
            return roots == 0 ? a.signum() : roots;
        }
        BigDecimal twice = b.multiply(c).multiply(new BigDecimal(-2));
        return a.signum() * sign(a.pow(2).subtract(bb).subtract(cc), twice, x.multiply(y));
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
