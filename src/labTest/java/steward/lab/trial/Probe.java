package steward.lab.trial;

import java.math.BigDecimal;
import java.util.stream.IntStream;
import steward.lab.oracle.OracleBody;
import steward.physics.Bodies;

/** Observer of turns that stores none: it counts impacts, and notes whether the impact limit was reported. */
public class Probe extends ImpactCount {

    /** How many turns ended at the impact limit and reported it. */
    public int limited;
    /** The impulse of the last impact. */
    public double impulse;

    @Override
    public void impact(double time, int a, int b, double ax, double ay, double bx, double by, double nx, double ny,
                       double j, double energy, double massA, double massB, double vax, double vay, double vaxAfter,
                       double vayAfter, double vbx, double vby, double vbxAfter, double vbyAfter) {
        super.impact(time, a, b, ax, ay, bx, by, nx, ny, j, energy, massA, massB, vax, vay, vaxAfter, vayAfter, vbx,
            vby, vbxAfter, vbyAfter);
        impulse = j;
        touched(a, b, ax, ay, bx, by);
    }

    /** Called when two have touched, with their centres at that time; for a wall b is negative. */
    public void touched(int a, int b, double ax, double ay, double bx, double by) { }

    @Override
    public void impactLimit(double time, int[] bodyIds) {
        limited++;
    }

    public static boolean finite(Bodies bodies) {
        return IntStream.range(0, bodies.size()).allMatch(k -> Double.isFinite(bodies.x[k])
            && Double.isFinite(bodies.y[k]) && Double.isFinite(bodies.vx[k]) && Double.isFinite(bodies.vy[k]));
    }

    /** Kinetic energy of the stored numbers, computed exactly. */
    public static BigDecimal energy(Bodies bodies) {
        return OracleBody.of(bodies).stream().map(OracleBody::energy).reduce(BigDecimal.ZERO, BigDecimal::add);
    }

    /** True if two bodies agree in every bit of position and velocity. */
    public static boolean same(Bodies one, int i, Bodies other, int j) {
        return bits(one.x[i]) == bits(other.x[j]) && bits(one.y[i]) == bits(other.y[j])
            && bits(one.vx[i]) == bits(other.vx[j]) && bits(one.vy[i]) == bits(other.vy[j]);
    }

    /** True if two worlds of as many bodies agree in every bit of every position and velocity. */
    public static boolean same(Bodies one, Bodies other) {
        return IntStream.range(0, one.size()).allMatch(k -> same(one, k, other, k));
    }

    private static long bits(double value) {
        return Double.doubleToLongBits(value + 0.0);
    }
}
