package steward.physics;

/**
 * A round wall around the bodies. A body that moves along its rim slides. If the next contact would come within about
 * 1/250 of a turn (1/5000 if it is elastic), it keeps the speed and flies on along a chord to its place on the rim
 * 1/250 turn later. At most some 250 such contacts a turn are recorded, with the change of energy 0. Between them place
 * and velocity are those of the chord: for an angle w per turn, up to w / 500 off in direction, (w / 500)^3 / 3 radians
 * ahead and (w / 500)^2 / 2 of the room inside. Speed across the rim at the beginning of a slide puts the body up to
 * 4.5e-6 w^3 radians ahead in each turn, 2e-9 w^3 if it is elastic. A round bumper has its rim outside: a body leaves
 * it in a straight line.
 *
 * @param x           its centre
 * @param y           its centre
 * @param radius      above 0; every body inside must be smaller
 * @param restitution 0..1
 */
public record Arena(double x, double y, double radius, double restitution) implements Wall {

    /** @throws IllegalArgumentException if a number is not finite or the radius or restitution out of range */
    public Arena {
        Wall.require(Double.isFinite(x), "x", x, "a finite number");
        Wall.require(Double.isFinite(y), "y", y, "a finite number");
        Wall.require(radius > 0 && radius < Double.POSITIVE_INFINITY, "radius", radius, "finite and above 0");
        Wall.requireRestitution(restitution);
    }

    @Override
    public double gap(double cx, double cy, double bodyRadius) {
        return radius - bodyRadius - distance(cx, cy);
    }

    @Override
    public double normalX(double cx, double cy) {
        double distance = distance(cx, cy);
        return distance == 0 ? 1 : (cx - x) / distance;
    }

    @Override
    public double normalY(double cx, double cy) {
        double distance = distance(cx, cy);
        return distance == 0 ? 0 : (cy - y) / distance;
    }

    private double distance(double cx, double cy) {
        double dx = cx - x;
        double dy = cy - y;
        return Math.sqrt(dx * dx + dy * dy);
    }
}
