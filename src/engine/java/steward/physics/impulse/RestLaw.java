package steward.physics.impulse;

import java.util.Arrays;
import steward.physics.Bodies;
import steward.physics.PhysicsParts;
import steward.physics.Wall;

/**
 * Law of the impacts that give nothing back, by the first point of {@link Rest}. A body has to be seen before it is
 * asked about; the largest kinetic energy of each in the turn is kept from one look to the next.
 */
final class RestLaw {

    /** Speeds along the normal below this share of those that a body has had: 2^-40 of the energy. */
    private static final double FEEBLE = 0x1p-20;
    /** Room for rounding in the threshold by forces. */
    static final double ROUNDING = 0x1p-30;

    private final Wall[] walls;
    private final RestitutionRule restitutionRule;
    /** {@code null} where no force acts. */
    private final Accelerations accelerations;
    /** Of the law; NaN for the default. */
    private final double restSpeed;
    /** The root of the largest m v.v that a body has had in this turn. */
    private double[] most = new double[0];
    /** The velocities of bodies at the instant at which they were seen. */
    double[] instantX = new double[0];
    double[] instantY = new double[0];
    /** From one to the other, as {@link #look} has seen it last. */
    double normalX;
    double normalY;
    double gap;

    RestLaw(PhysicsParts parts, Wall[] walls, Accelerations accelerations) {
        this.walls = walls;
        this.accelerations = accelerations;
        restSpeed = parts.law().restSpeed();
        restitutionRule = RestitutionRule.of(parts.law());
    }

    void begin(Bodies bodies) {
        if (most.length < bodies.size()) {
            most = new double[bodies.capacity()];
            instantX = new double[bodies.capacity()];
            instantY = new double[bodies.capacity()];
        }
        Arrays.fill(most, 0, bodies.size(), 0);
    }

    /** Takes note of the velocity and the energy of a body. */
    void see(Bodies bodies, int i, double half) {
        boolean forced = accelerations != null;
        instantX[i] = forced ? bodies.vx[i] + accelerations.x[i] * half : bodies.vx[i];
        instantY[i] = forced ? bodies.vy[i] + accelerations.y[i] * half : bodies.vy[i];
        most[i] = bodies.inverseMass[i] > 0
            ? Math.max(most[i], Math.sqrt(bodies.mass[i]) * length(bodies.vx[i], bodies.vy[i]))
            : Double.POSITIVE_INFINITY;
    }

    /** The length of a vector, without overflow. */
    private static double length(double x, double y) {
        double large = Math.max(Math.abs(x), Math.abs(y));
        double share = Math.min(Math.abs(x), Math.abs(y)) / large;
        return large == 0 ? 0 : large * Math.sqrt(1 + share * share);
    }

    double restitution(Bodies bodies, int a, int b) {
        return b < 0 ? restitutionRule.atWall(bodies, a, walls[~b]) : restitutionRule.betweenBodies(bodies, a, b);
    }

    /** True if an impact at this approach speed gives nothing back; also if two do not approach, and could rest. */
    boolean isRest(Bodies bodies, int a, int b, double approach) {
        double restitution = restitution(bodies, a, b);
        if (restitution == 0 || restitution == 1) {
            return restitution == 0;
        }
        if (!Double.isNaN(restSpeed)) {
            return restitution * approach <= restSpeed;
        }
        double force = accelerations == null ? 0 : accelerations.largest(bodies, a, b);
        return 2 * restitution * approach <= force * (1 + ROUNDING) || isFeeble(bodies, a, b, approach);
    }

    private boolean isFeeble(Bodies bodies, int a, int b, double approach) {
        double inverse = bodies.inverseMass[a] + (b < 0 ? 0 : bodies.inverseMass[b]);
        return approach < FEEBLE * Math.min(most[a], b < 0 ? most[a] : most[b]) * Math.sqrt(inverse);
    }

    /** The approach speed of two that have been seen. */
    double approach(Bodies bodies, int a, int b) {
        look(bodies, a, b);
        return normalX * (instantX[a] - (b < 0 ? 0 : instantX[b]))
            + normalY * (instantY[a] - (b < 0 ? 0 : instantY[b]));
    }

    void look(Bodies bodies, int a, int b) {
        double x = bodies.x[a];
        double y = bodies.y[a];
        if (b < 0) {
            normalX = walls[~b].normalX(x, y);
            normalY = walls[~b].normalY(x, y);
            gap = walls[~b].gap(x, y, bodies.radius[a]);
            return;
        }
        double dx = bodies.x[b] - x;
        double dy = bodies.y[b] - y;
        double distance = length(dx, dy);
        normalX = distance == 0 ? 1 : dx / distance;
        normalY = distance == 0 ? 0 : dy / distance;
        gap = distance - bodies.radius[a] - bodies.radius[b];
    }

    static double radii(Bodies bodies, int a, int b) {
        return bodies.radius[a] + (b < 0 ? 0 : bodies.radius[b]);
    }

    /** The acceleration by forces along a normal, of a body to another or to a wall. */
    double accelerated(Bodies bodies, int i, int j, double nx, double ny) {
        double x = accelerations.forces.x(bodies, i) - (j < 0 ? 0 : accelerations.forces.x(bodies, j));
        double y = accelerations.forces.y(bodies, i) - (j < 0 ? 0 : accelerations.forces.y(bodies, j));
        return nx * x + ny * y;
    }
}
