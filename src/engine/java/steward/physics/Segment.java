package steward.physics;

/**
 * A straight wall between two points; bodies bounce off both sides and both ends.
 *
 * @param ax          one end
 * @param ay          one end
 * @param bx          the other end
 * @param by          the other end
 * @param restitution 0..1
 */
public record Segment(double ax, double ay, double bx, double by, double restitution) implements Wall {

    /** @throws IllegalArgumentException if a number is not finite, the ends coincide or the restitution not in 0..1 */
    public Segment {
        double length = Math.sqrt((bx - ax) * (bx - ax) + (by - ay) * (by - ay));
        Wall.require(length > 0 && length < Double.POSITIVE_INFINITY, "length of a segment", length,
            "finite and above 0");
        Wall.requireRestitution(restitution);
    }

    @Override
    public double gap(double x, double y, double radius) {
        return distance(x, y) - radius;
    }

    @Override
    public double normalX(double x, double y) {
        double distance = distance(x, y);
        return distance == 0 ? (by - ay) / length() : (nearestX(x, y) - x) / distance;
    }

    @Override
    public double normalY(double x, double y) {
        double distance = distance(x, y);
        return distance == 0 ? -(bx - ax) / length() : (nearestY(x, y) - y) / distance;
    }

    /** The distance between its ends. */
    public double length() {
        return Math.sqrt((bx - ax) * (bx - ax) + (by - ay) * (by - ay));
    }

    private double distance(double x, double y) {
        double dx = nearestX(x, y) - x;
        double dy = nearestY(x, y) - y;
        return Math.sqrt(dx * dx + dy * dy);
    }

    private double nearestX(double x, double y) {
        return ax + share(x, y) * (bx - ax);
    }

    private double nearestY(double x, double y) {
        return ay + share(x, y) * (by - ay);
    }

    /** Returns where on the segment the nearest point is: 0 at a, 1 at b. */
    private double share(double x, double y) {
        double dx = bx - ax;
        double dy = by - ay;
        return Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy)));
    }
}
