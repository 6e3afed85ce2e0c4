package steward.physics.event;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.function.Supplier;
import steward.numerics.SplitMix64;
import steward.physics.Advance;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.Forces;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.TurnLog;
import steward.physics.Wall;

/** Small worlds that several tests of the physics share, and sums over them. */
public final class Scenes {

    /** Physics with the lower of two restitutions. */
    public static final ImpactLaw WITH_RESTITUTION = ImpactLaw.PHYSICS.withRestitution(ImpactLaw.Restitution.MINIMUM);

    private Scenes() {
    }

    /** Parts with one kind of bodies, of any mass, that bounce. */
    public static PhysicsParts parts(ImpactLaw law, Arithmetic arithmetic, Wall... walls) {
        return new PhysicsParts(law, arithmetic, new Contacts(1), List.of(walls), null, true);
    }

    static EventAdvance advance(ImpactLaw law, Wall... walls) {
        return new EventAdvance(parts(law, Arithmetic.DOUBLE, walls));
    }

    /** The two ways from impact to impact: by all pairs, and as a crowd. */
    static List<Advance> both(PhysicsParts parts) {
        return List.of(new EventAdvance(parts), new QueueAdvance(parts));
    }

    /** Plays a turn. @return its log */
    public static TurnLog turn(Advance advance, Bodies bodies) {
        TurnLog log = new TurnLog();
        advance.turn(bodies, log);
        return log;
    }

    /** Bodies of a row each: x, y, vx, vy, then mass and radius where they are not 1 and 10; some more find room. */
    public static Bodies bodies(double[]... rows) {
        Bodies bodies = new Bodies(rows.length + 8);
        for (double[] row : rows) {
            bodies.setVelocity(bodies.add(row[0], row[1], row.length > 5 ? row[5] : 10, row.length > 4 ? row[4] : 1),
                row[2], row[3]);
        }
        return bodies;
    }

    /** Plays a turn in two ways, which must end alike, with the same impacts. @return how many there were */
    static int assertSameTurn(Advance expected, Advance found, Bodies bodies, String what) {
        Bodies copy = bodies.copy();
        TurnLog log = turn(found, bodies);
        assertSameImpacts(turn(expected, copy), log, () -> what);
        assertArrayEquals(bits(copy), bits(bodies), what);
        return log.impacts();
    }

    /** Requires the same impacts and knots, to the last bit. */
    public static void assertSameLog(TurnLog expected, TurnLog found, Supplier<String> where) {
        assertSameImpacts(expected, found, where);
        assertEquals(expected.knots(), found.knots(), where);
        for (int k = 0; k < expected.knots(); k++) {
            assertEquals(List.of(expected.knotBody(k), expected.knotTime(k), expected.knotX(k), expected.knotY(k)),
                List.of(found.knotBody(k), found.knotTime(k), found.knotX(k), found.knotY(k)), where);
        }
    }

    private static void assertSameImpacts(TurnLog expected, TurnLog found, Supplier<String> where) {
        assertEquals(expected.impacts(), found.impacts(), where);
        for (int k = 0; k < expected.kept(); k++) {
            assertEquals(expected.impact(k), found.impact(k), where);
        }
    }

    /** Gives all bodies this restitution. */
    public static void setRestitution(Bodies bodies, double restitution) {
        for (int k = 0; k < bodies.size(); k++) {
            bodies.setRestitution(k, restitution);
        }
    }

    /** Adds a body of radius 10 with a velocity. */
    public static int add(Bodies bodies, double x, double y, double vx, double vy, double mass) {
        int body = bodies.add(x, y, 10, mass);
        bodies.setVelocity(body, vx, vy);
        return body;
    }

    /** Accelerates all bodies as forces do at the beginning of a turn. */
    public static void accelerate(Forces forces, Bodies bodies) {
        for (int k = 0; k < bodies.size(); k++) {
            forces.accelerate(bodies, k, 0, 0);
        }
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

    /** Place and velocity of a body: x, y, vx, vy. */
    static double[] state(Bodies bodies, int body) {
        return new double[] {bodies.x[body], bodies.y[body], bodies.vx[body], bodies.vy[body]};
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
