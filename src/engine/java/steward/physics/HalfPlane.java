package steward.physics;

/**
 * A straight wall of infinite length. Its vector is normalised, so that a vector written with few digits, such as
 * 0.7071, does not change the speed of a body that bounces.
 *
 * @param x           a point on its edge
 * @param y           a point on its edge
 * @param insideX     unit vector into the side where bodies may be
 * @param insideY     unit vector into the side where bodies may be
 * @param restitution 0..1
 */
public record HalfPlane(double x, double y, double insideX, double insideY, double restitution) implements Wall {

    private static final double TOLERANCE = 1e-3;

    /**
     * @throws IllegalArgumentException if a number is not finite, the vector not of length 1 (to 1e-3) or the
     *                                  restitution not in 0..1
     */
    public HalfPlane {
        Wall.require(Double.isFinite(x), "x", x, "a finite number");
        Wall.require(Double.isFinite(y), "y", y, "a finite number");
        double length = Math.sqrt(insideX * insideX + insideY * insideY);
        Wall.require(Math.abs(length - 1) <= TOLERANCE, "length of the inside vector", length, "1");
        Wall.requireRestitution(restitution);
        insideX /= length;
        insideY /= length;
    }

    @Override
    public double gap(double cx, double cy, double radius) {
        return (cx - x) * insideX + (cy - y) * insideY - radius;
    }

    @Override
    public double normalX(double cx, double cy) {
        return -insideX;
    }

    @Override
    public double normalY(double cx, double cy) {
        return -insideY;
    }
}
