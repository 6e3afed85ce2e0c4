package steward.lab.oracle;

import java.math.BigDecimal;
import steward.physics.Arena;
import steward.physics.HalfPlane;
import steward.physics.Segment;
import steward.physics.Wall;

/** Where a wall is, in the oracle's arithmetic: the unit vector from a body straight to it, and the gap between. */
final class OracleWall {

    private OracleWall() {
    }

    /** From the centre of the body to the wall, of length 1; along x for a body in the middle of an arena. */
    static BigDecimal[] normal(OracleBody body, Wall wall) {
        if (wall instanceof HalfPlane plane) {
            return unit(Digits.of(-plane.insideX()), Digits.of(-plane.insideY()));
        }
        if (wall instanceof Arena arena) {
            BigDecimal dx = body.x.subtract(Digits.of(arena.x()));
            BigDecimal dy = body.y.subtract(Digits.of(arena.y()));
            return dx.signum() == 0 && dy.signum() == 0
                ? new BigDecimal[] {BigDecimal.ONE, BigDecimal.ZERO} : unit(dx, dy);
        }
        Segment segment = (Segment) wall;
        BigDecimal[] nearest = nearest(body, segment);
        BigDecimal dx = nearest[0].subtract(body.x);
        BigDecimal dy = nearest[1].subtract(body.y);
        return dx.signum() == 0 && dy.signum() == 0
            ? unit(Digits.of(segment.by()).subtract(Digits.of(segment.ay())),
                Digits.of(segment.ax()).subtract(Digits.of(segment.bx())))
            : unit(dx, dy);
    }

    /** From the edge of the body to the wall; 0 or less when they touch. */
    static BigDecimal gap(OracleBody body, Wall wall) {
        if (wall instanceof HalfPlane plane) {
            BigDecimal[] n = normal(body, plane);
            return Digits.dot(n[0], n[1], Digits.of(plane.x()).subtract(body.x), Digits.of(plane.y()).subtract(body.y))
                .subtract(body.radius);
        }
        if (wall instanceof Arena arena) {
            return Digits.of(arena.radius()).subtract(body.radius).subtract(
                Digits.length(body.x.subtract(Digits.of(arena.x())), body.y.subtract(Digits.of(arena.y()))));
        }
        BigDecimal[] nearest = nearest(body, (Segment) wall);
        return Digits.length(nearest[0].subtract(body.x), nearest[1].subtract(body.y)).subtract(body.radius);
    }

    /** The point of a segment nearest to a body's centre: its foot on the line, or the end beyond which that lies. */
    static BigDecimal[] nearest(OracleBody body, Segment wall) {
        BigDecimal ax = Digits.of(wall.ax());
        BigDecimal ay = Digits.of(wall.ay());
        BigDecimal dx = Digits.of(wall.bx()).subtract(ax);
        BigDecimal dy = Digits.of(wall.by()).subtract(ay);
        BigDecimal share = Digits.divide(Digits.dot(body.x.subtract(ax), body.y.subtract(ay), dx, dy),
            Digits.dot(dx, dy, dx, dy));
        BigDecimal on = share.max(BigDecimal.ZERO).min(BigDecimal.ONE);
        return new BigDecimal[] {ax.add(on.multiply(dx)), ay.add(on.multiply(dy))};
    }

    private static BigDecimal[] unit(BigDecimal x, BigDecimal y) {
        BigDecimal length = Digits.length(x, y);
        return new BigDecimal[] {Digits.divide(x, length), Digits.divide(y, length)};
    }
}
