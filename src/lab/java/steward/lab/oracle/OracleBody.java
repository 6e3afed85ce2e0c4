package steward.lab.oracle;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import steward.physics.Bodies;

/** Body of the oracle: a circle whose position and velocity have {@link Decimals#COUNT} digits. */
public final class OracleBody {

    public BigDecimal x;
    public BigDecimal y;
    public BigDecimal vx;
    public BigDecimal vy;
    public final BigDecimal radius;
    /** {@code null} for an infinite mass. */
    final BigDecimal mass;
    final BigDecimal restitution;
    /** The acceleration in this turn: by forces, less what carries a body at rest. */
    BigDecimal ax = BigDecimal.ZERO;
    BigDecimal ay = BigDecimal.ZERO;
    /** The largest m v.v in this turn. */
    BigDecimal most = BigDecimal.ZERO;
    /** True if the body's heap has come to rest in this turn. */
    boolean rested;

    private OracleBody(Bodies from, int k) {
        x = Decimals.of(from.x[k]);
        y = Decimals.of(from.y[k]);
        vx = Decimals.of(from.vx[k]);
        vy = Decimals.of(from.vy[k]);
        radius = Decimals.of(from.radius[k]);
        mass = from.mass[k] == Double.POSITIVE_INFINITY ? null : Decimals.of(from.mass[k]);
        restitution = Decimals.of(from.restitution[k]);
    }

    /** All bodies, with the stored values converted exactly. */
    public static List<OracleBody> of(Bodies bodies) {
        return IntStream.range(0, bodies.size()).mapToObj(k -> new OracleBody(bodies, k))
            .collect(Collectors.toCollection(ArrayList::new));
    }

    BigDecimal inverseMass() {
        return mass == null ? BigDecimal.ZERO : Decimals.divide(BigDecimal.ONE, mass);
    }

    /** Moves the body along a straight line. */
    void fly(BigDecimal time) {
        move(vx.multiply(time), vy.multiply(time));
    }

    void move(BigDecimal dx, BigDecimal dy) {
        x = Decimals.round(x.add(dx));
        y = Decimals.round(y.add(dy));
    }

    /** Applies an impulse along a unit vector; an infinite mass does not change. */
    void push(BigDecimal impulse, BigDecimal nx, BigDecimal ny) {
        if (mass != null) {
            BigDecimal change = Decimals.divide(impulse, mass);
            vx = Decimals.round(vx.add(change.multiply(nx)));
            vy = Decimals.round(vy.add(change.multiply(ny)));
        }
    }

    /** Adds the acceleration during a part of a turn to the velocity. */
    void accelerate(BigDecimal turns) {
        vx = Decimals.round(vx.add(ax.multiply(turns)));
        vy = Decimals.round(vy.add(ay.multiply(turns)));
    }

    /** Takes note of the kinetic energy. */
    void see() {
        most = most.max(energy().multiply(BigDecimal.valueOf(2)));
    }

    void reverse() {
        vx = vx.negate();
        vy = vy.negate();
    }

    /** Kinetic energy m v.v / 2, exact; 0 for an infinite mass. */
    public BigDecimal energy() {
        return mass == null ? BigDecimal.ZERO
            : Decimals.dot(vx, vy, vx, vy).multiply(mass).divide(BigDecimal.valueOf(2));
    }
}
