package steward.physics.time;

import steward.physics.Arena;
import steward.physics.HalfPlane;
import steward.physics.Segment;
import steward.physics.Wall;

/**
 * Time at which a circle in free flight first touches a wall, in turns from now; for another circle see {@link
 * CircleTime}. "Never" is {@code POSITIVE_INFINITY}. A present contact counts as 0 only while the two approach; a
 * tangent path is a miss. Inputs are finite.
 *
 * <p>All methods are pure; lengths in u, velocities in u per turn. Products of up to four of the inputs have to be in
 * the range of doubles: {@code EventAdvance} ensures that.
 */
public final class TimeOfImpact {

    private static final double NEVER = Double.POSITIVE_INFINITY;

    private TimeOfImpact() { }

    /**
     * Circle and wall of any shape. For a body larger than an arena, the room for its centre is 0.
     *
     * @param x centre of the circle
     * @return 0 if the two touch already and approach
     */
    public static double wall(Wall wall, double x, double y, double vx, double vy, double radius) {
        if (wall instanceof HalfPlane plane) {
            return halfPlane(plane.gap(x, y, radius), -(vx * plane.insideX() + vy * plane.insideY()));
        }
        if (wall instanceof Segment segment) {
            return segment(x, y, vx, vy, radius, segment.ax(), segment.ay(), segment.bx(), segment.by(),
                segment.length());
        }
        Arena arena = (Arena) wall;
        return arena(x - arena.x(), y - arena.y(), vx, vy, Math.max(0, arena.radius() - radius));
    }

    /**
     * Circle and half-plane: the circle stays on the side to which the unit normal points.
     *
     * @param gap     from the circle's edge to the plane's edge; 0 or less when they touch
     * @param closing the speed at which the gap shrinks
     */
    public static double halfPlane(double gap, double closing) {
        if (!(closing > 0)) {
            return NEVER;
        }
        return gap <= 0 ? 0 : gap / closing;
    }

    /**
     * Circle and segment, end points included: the centre hits the segment expanded by the radius, which has two flat
     * sides and two round ends.
     *
     *          side
     *        _________
     *       (  A---B  )   round ends
     *        ---------
     *
     * The distance to a segment along a straight flight is convex: a circle that recedes from the nearest point never
     * hits the segment.
     *
     * @param x      centre of the circle
     * @param ax     one end of the segment
     * @param bx     the other end
     * @param length the distance between the ends, above 0
     */
    public static double segment(double x, double y, double vx, double vy, double radius,
                                 double ax, double ay, double bx, double by, double length) {
        double alongX = (bx - ax) / length;
        double alongY = (by - ay) / length;
        double side = alongX * (y - ay) - alongY * (x - ax);              // signed distance to the line
        double rise = alongX * vy - alongY * vx;
        double closing = side < 0 ? rise : -rise;
        double along = alongX * (x - ax) + alongY * (y - ay);
        double approach = along < 0 ? (ax - x) * vx + (ay - y) * vy
            : along > length ? (bx - x) * vx + (by - y) * vy : closing;
        if (!(approach > 0)) {
            return NEVER;
        }
        double first = halfPlane(Math.abs(side) - radius, closing);
        if (first < NEVER) {
            double foot = alongX * (x + vx * first - ax) + alongY * (y + vy * first - ay);
            if (foot >= 0 && foot <= length) {
                return first;
            }
        }
        return Math.min(CircleTime.stable(ax - x, ay - y, -vx, -vy, radius),
            CircleTime.stable(bx - x, by - y, -vx, -vy, radius));
    }

    /*
     * Circle inside a circular arena. With d from the arena's centre and s the room for the centre, |d + v t| = s is
     * the quadratic of CircleTime, but from inside (c <= 0) the larger root (-b + sqrt D) / a counts. For b <= 0 its
     * numerator is a sum of positive terms; for b > 0 the denominator of the other form, -c / (b + sqrt D), is.
     */

    /**
     * Circle inside a circular arena.
     *
     * @param dx   from the centre of the arena to the centre of the circle
     * @param room radius of the arena less that of the circle: how far the centre may go, at least 0
     */
    public static double arena(double dx, double dy, double vx, double vy, double room) {
        double b = dx * vx + dy * vy;
        double distance = Math.sqrt(dx * dx + dy * dy);
        double c = (distance - room) * (distance + room);
        if (c >= 0 && b > 0) {
            return 0;
        }
        double speed = Math.sqrt(vx * vx + vy * vy);
        if (speed == 0) {
            return NEVER;
        }
        double offset = Math.abs(dx * vy - dy * vx);
        double discriminant = (speed * room - offset) * (speed * room + offset);
        if (!(discriminant > 0)) {
            return Math.max(0, -b / (speed * speed));  // never inside: an impact at the closest approach
        }
        double squareRoot = Math.sqrt(discriminant);
        return b <= 0 ? (squareRoot - b) / (speed * speed) : -c / (b + squareRoot);
    }
}
