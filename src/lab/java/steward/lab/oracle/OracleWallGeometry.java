package steward.lab.oracle;

import java.math.BigDecimal;
import java.util.Collections;
import java.util.Map;
import java.util.WeakHashMap;
import steward.physics.Arena;
import steward.physics.HalfPlane;
import steward.physics.Segment;
import steward.physics.Wall;

/** Geometry of walls in the oracle's arithmetic: the unit vector from a body to the wall, and the gap between them. */
final class OracleWallGeometry {

    /** Normals of planes: a root for each body in each scan would cost more than all the rest. */
    private static final Map<HalfPlane, BigDecimal[]> PLANES = Collections.synchronizedMap(new WeakHashMap<>());

    /** Unit vector from the centre of the body to the wall; along x for a body in the middle of an arena. */
    static BigDecimal[] normal(OracleBody body, Wall wall) {
        if (wall instanceof HalfPlane plane) {
            return PLANES.computeIfAbsent(plane, any -> unit(Decimals.of(-plane.insideX()),
                Decimals.of(-plane.insideY()))).clone();
        }
        if (wall instanceof Arena arena) {
            BigDecimal dx = body.x.subtract(Decimals.of(arena.x()));
            BigDecimal dy = body.y.subtract(Decimals.of(arena.y()));
            return dx.signum() == 0 && dy.signum() == 0
                ? new BigDecimal[] {BigDecimal.ONE, BigDecimal.ZERO} : unit(dx, dy);
        }
        Segment segment = (Segment) wall;
        BigDecimal[] nearest = nearest(body, segment);
        BigDecimal dx = nearest[0].subtract(body.x);
        BigDecimal dy = nearest[1].subtract(body.y);
        return dx.signum() == 0 && dy.signum() == 0
            ? unit(Decimals.of(segment.by()).subtract(Decimals.of(segment.ay())),
                Decimals.of(segment.ax()).subtract(Decimals.of(segment.bx())))
            : unit(dx, dy);
    }

    /** Distance from the edge of the body to the wall; 0 or less when they touch. */
    static BigDecimal gap(OracleBody body, Wall wall) {
        if (wall instanceof HalfPlane plane) {
            BigDecimal[] n = normal(body, plane);
            return Decimals
                .dot(n[0], n[1], Decimals.of(plane.x()).subtract(body.x), Decimals.of(plane.y()).subtract(body.y))
                .subtract(body.radius);
        }
        if (wall instanceof Arena arena) {
            return Decimals.of(arena.radius()).subtract(body.radius).subtract(
                Decimals.length(body.x.subtract(Decimals.of(arena.x())), body.y.subtract(Decimals.of(arena.y()))));
        }
        BigDecimal[] nearest = nearest(body, (Segment) wall);
        return Decimals.length(nearest[0].subtract(body.x), nearest[1].subtract(body.y)).subtract(body.radius);
    }

    /**
     * The point of a segment nearest to a body's centre: the foot on the line, or the end beyond which the foot lies.
     */
    static BigDecimal[] nearest(OracleBody body, Segment wall) {
        BigDecimal ax = Decimals.of(wall.ax());
        BigDecimal ay = Decimals.of(wall.ay());
        BigDecimal dx = Decimals.of(wall.bx()).subtract(ax);
        BigDecimal dy = Decimals.of(wall.by()).subtract(ay);
        BigDecimal share = Decimals.divide(Decimals.dot(body.x.subtract(ax), body.y.subtract(ay), dx, dy),
            Decimals.dot(dx, dy, dx, dy));
        BigDecimal on = share.max(BigDecimal.ZERO).min(BigDecimal.ONE);
        return new BigDecimal[] {ax.add(on.multiply(dx)), ay.add(on.multiply(dy))};
    }

    private static BigDecimal[] unit(BigDecimal x, BigDecimal y) {
        BigDecimal length = Decimals.length(x, y);
        return new BigDecimal[] {Decimals.divide(x, length), Decimals.divide(y, length)};
    }
}
