package steward.lab.oracle;

import java.math.BigDecimal;
import steward.physics.Arena;
import steward.physics.HalfPlane;
import steward.physics.Segment;
import steward.physics.Wall;

/*
 * A point p that flies with v reaches the distance s from the origin when |p + v t| = s:
 *
 *     (v.v) t^2 + 2 (p.v) t + (p.p - s^2) = 0,     D = (p.v)^2 - (v.v)(p.p - s^2) = (v.v) s^2 - (p x v)^2,
 *
 * the last by Lagrange's identity. The signs of p.v, p.p - s^2 and D decide; they are computed exactly from the stored
 * numbers. From outside the first touch is c / (sqrt D - p.v), from inside the last (sqrt D - p.v) / (v.v): neither
 * subtracts two numbers of the same sign when it matters.
 */

/**
 * Times of impact in the oracle's arithmetic, from the definitions; {@code null} means never. A body that touches and
 * approaches has the time 0. A body that touches but recedes or slides does not come back, because all walls and
 * circles here are convex.
 */
final class OracleTimeOfImpact {

    /** True if a point is within s of the origin; a distance equal to s except for rounding counts. */
    static boolean within(BigDecimal px, BigDecimal py, BigDecimal s) {
        return Decimals.atMost(Decimals.dot(px, py, px, py), Decimals.square(s));
    }

    /** True if p.v < 0; a slide, except for rounding, is no approach. */
    static boolean approaches(BigDecimal px, BigDecimal py, BigDecimal vx, BigDecimal vy, boolean touching) {
        BigDecimal approach = Decimals.dot(px, py, vx, vy);
        if (approach.signum() >= 0 || !touching) {
            return approach.signum() < 0;
        }
        BigDecimal most = Decimals.square(Decimals.SAME)
            .multiply(Decimals.dot(px, py, px, py)).multiply(Decimals.dot(vx, vy, vx, vy));
        return Decimals.square(approach).compareTo(most) > 0;
    }

    /**
     * From outside onto a circle of radius s; (px, py) points from the centre of the circle to the point, (vx, vy) is
     * the velocity of the point relative to the circle.
     */
    static BigDecimal circle(BigDecimal px, BigDecimal py, BigDecimal vx, BigDecimal vy, BigDecimal s) {
        boolean touching = within(px, py, s);
        if (!approaches(px, py, vx, vy, touching)) {
            return null;
        }
        if (touching) {
            return BigDecimal.ZERO;
        }
        BigDecimal discriminant = Decimals.dot(vx, vy, vx, vy).multiply(Decimals.square(s))
            .subtract(Decimals.square(Decimals.cross(px, py, vx, vy)));
        if (discriminant.signum() <= 0) {
            return null;                               // a tangent path is a miss
        }
        BigDecimal c = Decimals.dot(px, py, px, py).subtract(Decimals.square(s));
        return Decimals.divide(c, Decimals.root(discriminant).subtract(Decimals.dot(px, py, vx, vy)));
    }

    static BigDecimal wall(OracleBody body, Wall wall) {
        if (wall instanceof HalfPlane plane) {
            return halfPlane(body, plane);
        }
        return wall instanceof Arena arena ? arena(body, arena) : segment(body, (Segment) wall);
    }

    private static BigDecimal halfPlane(OracleBody body, HalfPlane plane) {
        BigDecimal[] n = OracleWallGeometry.normal(body, plane);
        BigDecimal gap = OracleWallGeometry.gap(body, plane);
        BigDecimal closing = Decimals.dot(body.vx, body.vy, n[0], n[1]);
        boolean touching = gap.compareTo(Decimals.SAME.multiply(body.radius)) <= 0;
        if (!approaches(n[0], n[1], body.vx.negate(), body.vy.negate(), touching)) {
            return null;
        }
        return gap.signum() <= 0 ? BigDecimal.ZERO : Decimals.divide(gap, closing);
    }

    /**
     * From inside onto the circle of radius (arena - body); if the body has no room, at the point nearest the centre.
     */
    private static BigDecimal arena(OracleBody body, Arena arena) {
        BigDecimal px = body.x.subtract(Decimals.of(arena.x()));
        BigDecimal py = body.y.subtract(Decimals.of(arena.y()));
        BigDecimal room = Decimals.of(arena.radius()).subtract(body.radius).max(BigDecimal.ZERO);
        BigDecimal a = Decimals.dot(body.vx, body.vy, body.vx, body.vy);
        BigDecimal b = Decimals.dot(px, py, body.vx, body.vy);
        if (a.signum() == 0) {
            return null;
        }
        BigDecimal c = Decimals.dot(px, py, px, py).subtract(Decimals.square(room));
        boolean outside = Decimals.atMost(Decimals.square(room), Decimals.dot(px, py, px, py));
        if (outside && b.signum() > 0) {
            return BigDecimal.ZERO;
        }
        BigDecimal discriminant = a.multiply(Decimals.square(room))
            .subtract(Decimals.square(Decimals.cross(px, py, body.vx, body.vy)));
        if (discriminant.signum() <= 0) {
            return Decimals.divide(b.negate(), a).max(BigDecimal.ZERO);
        }
        BigDecimal root = Decimals.root(discriminant);
        return b.signum() <= 0 ? Decimals.divide(root.subtract(b), a) : Decimals.divide(c.negate(), b.add(root));
    }

    /** The earliest touch of a segment: with its line, where the foot is between the ends, or with either end. */
    private static BigDecimal segment(OracleBody body, Segment wall) {
        BigDecimal[] nearest = OracleWallGeometry.nearest(body, wall);
        BigDecimal px = body.x.subtract(nearest[0]);
        BigDecimal py = body.y.subtract(nearest[1]);
        boolean touching = within(px, py, body.radius);
        if (touching) {
            return approaches(px, py, body.vx, body.vy, true) ? BigDecimal.ZERO : null;
        }
        BigDecimal alongX = Decimals.of(wall.bx()).subtract(Decimals.of(wall.ax()));
        BigDecimal alongY = Decimals.of(wall.by()).subtract(Decimals.of(wall.ay()));
        BigDecimal length = Decimals.length(alongX, alongY);
        BigDecimal side = Decimals.cross(alongX, alongY, body.x.subtract(Decimals.of(wall.ax())),
            body.y.subtract(Decimals.of(wall.ay())));                         // distance to the line, times the length
        BigDecimal rise = Decimals.cross(alongX, alongY, body.vx, body.vy);
        BigDecimal closing = side.signum() < 0 ? rise : rise.negate();
        BigDecimal gap = side.abs().subtract(body.radius.multiply(length));
        BigDecimal first = null;
        if (gap.signum() >= 0 && closing.signum() > 0) {
            BigDecimal time = Decimals.divide(gap, closing);
            BigDecimal foot = Decimals.dot(alongX, alongY,
                body.x.add(body.vx.multiply(time)).subtract(Decimals.of(wall.ax())),
                body.y.add(body.vy.multiply(time)).subtract(Decimals.of(wall.ay())));
            boolean between = foot.signum() >= 0 && foot.compareTo(Decimals.dot(alongX, alongY, alongX, alongY)) <= 0;
            first = between ? time : null;
        }
        first = earlier(first, end(body, wall.ax(), wall.ay()));
        return earlier(first, end(body, wall.bx(), wall.by()));
    }

    private static BigDecimal end(OracleBody body, double x, double y) {
        return circle(body.x.subtract(Decimals.of(x)), body.y.subtract(Decimals.of(y)), body.vx, body.vy, body.radius);
    }

    private static BigDecimal earlier(BigDecimal one, BigDecimal other) {
        return one == null ? other : other == null ? one : one.min(other);
    }
}
