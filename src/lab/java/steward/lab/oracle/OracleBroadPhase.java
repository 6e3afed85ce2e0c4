package steward.lab.oracle;

import java.math.BigDecimal;
import java.util.List;
import steward.physics.HalfPlane;
import steward.physics.Wall;

/**
 * Excludes pairs that are too far apart to meet in the rest of a turn: their distance is more than both radii plus the
 * longest way by which they can come nearer. This is decided in doubles with a margin a million times their rounding,
 * so that every pair that could possibly meet is examined in all digits.
 */
final class OracleBroadPhase {

    /** Relative margin; the doubles are accurate to some 1e-15. */
    private static final double MARGIN = 1e-9;
    /** Below this, and above its inverse, squares may have lost digits or left the range: nothing is excluded. */
    private static final double LEAST = 1e-140;
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

    /** A double within a few units in the last place, cheaper than the nearest one; or NaN. */
    private static double near(BigDecimal value) {
        int scale = value.scale();
        return scale < 0 || scale >= TENTH.length ? Double.NaN
            : value.unscaledValue().doubleValue() * TENTH[scale];
    }

    /**
     * True if two bodies cannot meet within a time.
     *
     * @param own distance at which they touch; NaN for the sum of their radii
     */
    boolean apart(int i, int j, double own, double time) {
        double dx = x[i] - x[j];
        double dy = y[i] - y[j];
        double ux = vx[i] - vx[j];
        double uy = vy[i] - vy[j];
        double touch = Double.isNaN(own) ? radius[i] + radius[j] : own;
        double near = touch + Math.sqrt(ux * ux + uy * uy) * time;
        double size = Math.abs(x[i]) + Math.abs(x[j]) + Math.abs(y[i]) + Math.abs(y[j]) + near
            + (Math.abs(vx[i]) + Math.abs(vx[j]) + Math.abs(vy[i]) + Math.abs(vy[j])) * time;
        return beyond(Math.sqrt(dx * dx + dy * dy), near, size);
    }

    /** True if a body cannot reach a wall within a time; only straight walls are ever excluded. */
    boolean apart(int i, Wall wall, double time) {
        if (!(wall instanceof HalfPlane plane)) {
            return false;
        }
        double length = Math.sqrt(plane.insideX() * plane.insideX() + plane.insideY() * plane.insideY());
        double gap = ((x[i] - plane.x()) * plane.insideX() + (y[i] - plane.y()) * plane.insideY()) / length;
        double speed = Math.abs(vx[i]) + Math.abs(vy[i]);
        double near = radius[i] + speed * time;
        return beyond(gap, near, Math.abs(x[i]) + Math.abs(y[i]) + Math.abs(plane.x()) + Math.abs(plane.y()) + near);
    }

    /** False for NaN. */
    private static boolean beyond(double distance, double near, double size) {
        return distance - near > MARGIN * size && size > LEAST && size < 1 / LEAST;
    }
}
