package steward.physics;

/** Immovable obstacle of infinite mass that bodies bounce off. */
public sealed interface Wall permits HalfPlane, Segment, Arena {

    /** The share of an approach speed that an impact gives back, 0..1; the lower of the two, wall and body, counts. */
    double restitution();

    /** The distance from a circle's edge to the wall, in u; 0 or less when they touch. */
    double gap(double x, double y, double radius);

    /** The x component of the unit vector from a circle's centre to the nearest point of the wall. */
    double normalX(double x, double y);

    /** The y component of the same vector. */
    double normalY(double x, double y);

    /** The four walls around a field from (0, 0): as {@link #box(double, double, double, double, double)}. */
    static Wall[] box(double width, double height, double restitution) {
        return box(0, 0, width, height, restitution);
    }

    /**
     * The four walls around a field from (x, y) to (x + width, y + height): left, top (lowest y), right, bottom.
     *
     * @throws IllegalArgumentException if a side is not finite and above 0 or the restitution not in 0..1
     */
    static Wall[] box(double x, double y, double width, double height, double restitution) {
        require(width > 0 && width < Double.POSITIVE_INFINITY, "width", width, "finite and above 0");
        require(height > 0 && height < Double.POSITIVE_INFINITY, "height", height, "finite and above 0");
        return new Wall[] {
            new HalfPlane(x, y, 1, 0, restitution), new HalfPlane(x, y, 0, 1, restitution),
            new HalfPlane(x + width, y, -1, 0, restitution), new HalfPlane(x, y + height, 0, -1, restitution)};
    }

    /** Throws unless the value is in range, saying which and what was expected. */
    static void require(boolean inRange, String what, double value, String expected) {
        if (!inRange) {
            throw new IllegalArgumentException("wall: " + what + " " + value + ", expected " + expected);
        }
    }

    /** Throws unless the restitution is in 0..1. */
    static void requireRestitution(double value) {
        require(value >= 0 && value <= 1, "restitution", value, "0..1");
    }
}
