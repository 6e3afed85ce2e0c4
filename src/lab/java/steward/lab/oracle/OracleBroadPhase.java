package steward.lab.oracle;

import java.math.BigDecimal;
import java.util.List;
import steward.physics.Arena;
import steward.physics.HalfPlane;
import steward.physics.Segment;
import steward.physics.Wall;

/*
 * The distance f(t) of a point on a straight line from a convex set is a convex function of the time: it never is less
 * than its tangent. With the nearest point q of the set, n = (p - q) / |p - q| and the closing speed -v.n,
 *
 *     f(t) >= |p - q| - t (-v.n),
 *
 * so that nothing comes within s before t = (|p - q| - s) / (-v.n), and never if -v.n <= 0. Circles, segments and
 * half-planes are convex. From inside an arena, with a = v.v and b = p.v, the distance from its centre grows by at most
 * |v| a turn, and whoever starts on the edge or outside it and turns inwards leaves it again after -b / a at the
 * earliest, where the path is nearest to the centre.
 *
 * A double made from 64 digits is off by at most 2 units in the last place, 4.5e-16 of its size. Each gap below is a
 * sum of such numbers of size E with at most 10 roundings, each closing speed one of products v n, where n is off by
 * as much as q is, over |p - q|. MARGIN is four times the worst of these sums.
 */

/**
 * Lower bounds in doubles of times of touch, so that the {@link Oracle} examines only possible next pairs in all
 * digits. Each bound has a margin above the rounding of its doubles; if squares could leave their range, it is 0.
 */
final class OracleBroadPhase {

    /** Bound on the rounding of a gap, relative to the numbers it is made of. */
    private static final double MARGIN = 1e-14;
    /** Nothing is excluded if a size is below this or above its inverse, where squares lose digits. */
    private static final double LEAST = 1e-70;
    private static final double NEVER = Double.POSITIVE_INFINITY;
    private static final double[] TENTH = new double[300];

    static {
        for (int k = 0; k < TENTH.length; k++) {
            TENTH[k] = Double.parseDouble("1e-" + k);
        }
    }

    private final double[] x;
    private final double[] y;
    private final double[] vx;
    private final double[] vy;
    private final double[] radius;

    OracleBroadPhase(List<OracleBody> bodies) {
        x = bodies.stream().mapToDouble(body -> near(body.x)).toArray();
        y = bodies.stream().mapToDouble(body -> near(body.y)).toArray();
        vx = bodies.stream().mapToDouble(body -> near(body.vx)).toArray();
        vy = bodies.stream().mapToDouble(body -> near(body.vy)).toArray();
        radius = bodies.stream().mapToDouble(body -> near(body.radius)).toArray();
    }

    /** A double within two units in the last place, cheaper than the nearest one; or NaN. */
    private static double near(BigDecimal value) {
        int scale = value.scale();
        return scale < 0 || scale >= TENTH.length ? Double.NaN
            : value.unscaledValue().doubleValue() * TENTH[scale];
    }

    /**
     * Returns a time before which two bodies do not touch.
     *
     * @param own        distance at which they touch; NaN for the sum of their radii
     * @param separating whether a pair that touches and recedes reacts
     */
    double earliest(int i, int j, double own, boolean separating) {
        double size = Math.abs(x[i]) + Math.abs(x[j]) + Math.abs(y[i]) + Math.abs(y[j]) + radius[i] + radius[j];
        double speed = Math.abs(vx[i]) + Math.abs(vx[j]) + Math.abs(vy[i]) + Math.abs(vy[j]);
        double touch = Double.isNaN(own) ? radius[i] + radius[j] : own;
        return convex(x[i] - x[j], y[i] - y[j], vx[i] - vx[j], vy[i] - vy[j], touch, size + touch, speed, separating);
    }

    /** Returns a time before which a body does not touch a wall. */
    double earliest(int i, Wall wall) {
        double size = Math.abs(x[i]) + Math.abs(y[i]) + radius[i];
        double speed = Math.abs(vx[i]) + Math.abs(vy[i]);
        if (wall instanceof HalfPlane plane) {
            double length = Math.sqrt(plane.insideX() * plane.insideX() + plane.insideY() * plane.insideY());
            double nx = plane.insideX() / length;
            double ny = plane.insideY() / length;
            double gap = (x[i] - plane.x()) * nx + (y[i] - plane.y()) * ny - radius[i];
            double sizes = size + Math.abs(plane.x()) + Math.abs(plane.y());
            return bound(gap, MARGIN * sizes, -(vx[i] * nx + vy[i] * ny), MARGIN * speed, sizes, speed, false);
        }
        if (wall instanceof Arena arena) {
            return inside(i, arena, size + Math.abs(arena.x()) + Math.abs(arena.y()) + arena.radius(), speed);
        }
        Segment segment = (Segment) wall;
        double dx = segment.bx() - segment.ax();
        double dy = segment.by() - segment.ay();
        double share = ((x[i] - segment.ax()) * dx + (y[i] - segment.ay()) * dy) / (dx * dx + dy * dy);
        double on = Math.max(0, Math.min(1, share));
        return convex(x[i] - (segment.ax() + on * dx), y[i] - (segment.ay() + on * dy), vx[i], vy[i], radius[i],
            size + Math.abs(segment.ax()) + Math.abs(segment.ay()) + Math.abs(segment.bx()) + Math.abs(segment.by()),
            speed, false);
    }

    /** From a point of a convex set, the nearest one, a body is (px, py) away and flies with (ux, uy). */
    private static double convex(double px, double py, double ux, double uy, double touch, double size, double speed,
                                 boolean separating) {
        double distance = Math.sqrt(px * px + py * py);
        double closing = -(px * ux + py * uy) / distance;
        double margin = MARGIN * size;
        return bound(distance - touch, margin, closing, MARGIN * speed + speed * margin / distance, size, speed,
            separating);
    }

    private double inside(int i, Arena arena, double size, double speed) {
        double px = x[i] - arena.x();
        double py = y[i] - arena.y();
        double gap = Math.max(0, arena.radius() - radius[i]) - Math.sqrt(px * px + py * py);
        double fast = Math.sqrt(vx[i] * vx[i] + vy[i] * vy[i]);
        double first = bound(gap, MARGIN * size, fast, MARGIN * speed, size, speed, false);
        double inwards = -(px * vx[i] + py * vy[i]) - 2 * MARGIN * size * speed;
        return inwards > 0 && first < NEVER
            ? Math.max(first, (1 - MARGIN) * inwards / (fast * fast + MARGIN * speed * speed)) : first;
    }

    /** The first time at which a gap can be closed; 0 for NaN. */
    private static double bound(double gap, double gapMargin, double closing, double closingMargin, double size,
                                double speed, boolean separating) {
        boolean known = size > LEAST && size < 1 / LEAST && speed < 1 / LEAST && (speed > LEAST || speed == 0);
        if (!known || separating && !(gap > gapMargin)) {
            return 0;
        }
        double most = closing + closingMargin;
        return most <= 0 ? NEVER : gap > gapMargin ? (1 - MARGIN) * (gap - gapMargin) / most : 0;
    }
}
