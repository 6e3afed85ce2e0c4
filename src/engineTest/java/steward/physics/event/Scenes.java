package steward.physics.event;

import java.util.List;
import steward.numerics.SplitMix64;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.Wall;

/** Small worlds that several tests of the physics share, and sums over them. */
public final class Scenes {

    /** Physics with the lower of two restitutions. */
    public static final ImpactLaw WITH_RESTITUTION = ImpactLaw.PHYSICS.withRestitution(ImpactLaw.Restitution.MINIMUM);

    private Scenes() {
    }

    static EventAdvance advance(ImpactLaw law, Wall... walls) {
        return new EventAdvance(
            new PhysicsParts(law, Arithmetic.DOUBLE, new Contacts(1), List.of(walls), null, true));
    }

    /** Adds a body of radius 10 with a velocity. */
    public static int add(Bodies bodies, double x, double y, double vx, double vy, double mass) {
        int body = bodies.add(x, y, 10, mass);
        bodies.setVelocity(body, vx, vy);
        return body;
    }

    /** Kinetic energy of all finite masses. */
    static double energy(Bodies bodies) {
        double sum = 0;
        for (int k = 0; k < bodies.size(); k++) {
            if (bodies.inverseMass[k] > 0) {
                sum += bodies.mass[k] * (bodies.vx[k] * bodies.vx[k] + bodies.vy[k] * bodies.vy[k]) / 2;
            }
        }
        return sum;
    }

    /** The deepest overlap of two bodies, or of a body and a wall; 0 or less if none overlap. */
    static double deepestOverlap(Bodies bodies, Wall... walls) {
        double deepest = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < bodies.size(); i++) {
            for (int j = 0; j < i; j++) {
                double distance = Math.hypot(bodies.x[i] - bodies.x[j], bodies.y[i] - bodies.y[j]);
                deepest = Math.max(deepest, bodies.radius[i] + bodies.radius[j] - distance);
            }
            for (Wall wall : walls) {
                deepest = Math.max(deepest, -wall.gap(bodies.x[i], bodies.y[i], bodies.radius[i]));
            }
        }
        return deepest;
    }

    static boolean allFinite(Bodies bodies) {
        for (int k = 0; k < bodies.size(); k++) {
            if (!Double.isFinite(bodies.x[k] + bodies.y[k] + bodies.vx[k] + bodies.vy[k])) {
                return false;
            }
        }
        return true;
    }

    /** Bodies on a grid in a field of side x side, each with a random offset, mass 1..4 and velocity. */
    public static Bodies grid(SplitMix64 random, int perRow, double side, double radius, double speed) {
        Bodies bodies = new Bodies(perRow * perRow);
        double cell = side / perRow;
        double play = cell / 2 - radius;
        for (int k = 0; k < perRow * perRow; k++) {
            int body = bodies.add((k % perRow + 0.5) * cell + play * (2 * random.nextDouble() - 1),
                (k / perRow + 0.5) * cell + play * (2 * random.nextDouble() - 1), radius, 1 + 3 * random.nextDouble());
            bodies.setVelocity(body, speed * (2 * random.nextDouble() - 1), speed * (2 * random.nextDouble() - 1));
        }
        return bodies;
    }

    /** The bits of all positions and velocities, in order. */
    public static long[] bits(Bodies bodies) {
        long[] bits = new long[4 * bodies.size()];
        for (int k = 0; k < bodies.size(); k++) {
            bits[4 * k] = Double.doubleToLongBits(bodies.x[k]);
            bits[4 * k + 1] = Double.doubleToLongBits(bodies.y[k]);
            bits[4 * k + 2] = Double.doubleToLongBits(bodies.vx[k]);
            bits[4 * k + 3] = Double.doubleToLongBits(bodies.vy[k]);
        }
        return bits;
    }
}
