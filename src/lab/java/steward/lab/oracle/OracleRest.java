package steward.lab.oracle;

import java.math.BigDecimal;
import java.util.List;
import steward.physics.Arena;
import steward.physics.Forces;
import steward.physics.ImpactLaw;
import steward.physics.Wall;

/**
 * Law of rest and of forces in the oracle's arithmetic, as {@code docs/scenes.md} describes it. It decides which
 * impacts give nothing back, and how bodies leave an impact under forces. {@link OracleHeap} computes heaps.
 */
final class OracleRest {

    private static final BigDecimal FEEBLE = Decimals.of(0x1p-40);
    private static final BigDecimal TWO = BigDecimal.valueOf(2);
    private static final BigDecimal QUARTER = new BigDecimal("0.25");
    /** A chord along a rim, in turns, of a contact that slides: a half more than the 250th part of a turn. */
    private static final BigDecimal CHORD = new BigDecimal("0.006");
    /** The sine of the flattest contact that is no slide. */
    private static final BigDecimal FLAT = Decimals.of(1.5 * 0x1p-20);

    private final ImpactLaw law;
    private final List<Wall> walls;
    private final Forces forces;

    OracleRest(ImpactLaw law, List<Wall> walls, Forces forces) {
        this.law = law;
        this.walls = walls;
        this.forces = forces;
    }

    /** True if a force acts. */
    boolean forced() {
        return forces.act();
    }

    /** The unit vector from one body to another or to {@code ~wall}; along x where there is none. */
    BigDecimal[] normal(List<OracleBody> bodies, int a, int b) {
        if (b < 0) {
            return OracleWallGeometry.normal(bodies.get(a), walls.get(~b));
        }
        BigDecimal dx = bodies.get(b).x.subtract(bodies.get(a).x);
        BigDecimal dy = bodies.get(b).y.subtract(bodies.get(a).y);
        BigDecimal distance = Decimals.length(dx, dy);
        return distance.signum() == 0 ? new BigDecimal[] {BigDecimal.ONE, BigDecimal.ZERO}
            : new BigDecimal[] {Decimals.divide(dx, distance), Decimals.divide(dy, distance)};
    }

    BigDecimal restitution(List<OracleBody> bodies, int a, int b) {
        return bodies.get(a).restitution.min(b < 0 ? Decimals.of(walls.get(~b).restitution())
            : bodies.get(b).restitution);
    }

    /** The speed at which two approach, a part of a turn from the middle of their flights. */
    BigDecimal approach(List<OracleBody> bodies, int a, int b, BigDecimal turns) {
        BigDecimal[] n = normal(bodies, a, b);
        OracleBody p = bodies.get(a);
        BigDecimal x = p.vx.add(p.ax.multiply(turns));
        BigDecimal y = p.vy.add(p.ay.multiply(turns));
        if (b >= 0) {
            OracleBody q = bodies.get(b);
            x = x.subtract(q.vx).subtract(q.ax.multiply(turns));
            y = y.subtract(q.vy).subtract(q.ay.multiply(turns));
        }
        return Decimals.dot(n[0], n[1], x, y);
    }

    /** True if an impact at this approach speed gives nothing back. */
    boolean isRest(List<OracleBody> bodies, int a, int b, BigDecimal approach) {
        BigDecimal restitution = restitution(bodies, a, b);
        if (!law.bodiesRest() || law.separatingPairsReact() || restitution.compareTo(BigDecimal.ONE) >= 0) {
            return false;
        }
        BigDecimal rebound = restitution.multiply(approach);
        if (restitution.signum() == 0 || !Double.isNaN(law.restSpeed())) {
            return restitution.signum() == 0 || rebound.compareTo(Decimals.of(law.restSpeed())) <= 0;
        }
        if (rebound.signum() <= 0 || Decimals.atMost(Decimals.square(rebound.multiply(TWO)), largest(bodies, a, b))) {
            return true;
        }
        OracleBody p = bodies.get(a);
        OracleBody q = b < 0 ? null : bodies.get(b);
        BigDecimal least = q == null || q.mass == null ? p.most : p.mass == null ? q.most : p.most.min(q.most);
        BigDecimal inverse = q == null ? p.inverseMass() : p.inverseMass().add(q.inverseMass());
        return Decimals.square(approach).compareTo(FEEBLE.multiply(least).multiply(inverse)) < 0;
    }

    /** The square of the larger acceleration by forces. */
    BigDecimal largest(List<OracleBody> bodies, int a, int b) {
        BigDecimal ofA = square(bodies.get(a));
        return b < 0 ? ofA : ofA.max(square(bodies.get(b)));
    }

    private BigDecimal square(OracleBody body) {
        BigDecimal[] a = forced(body);
        return Decimals.dot(a[0], a[1], a[0], a[1]);
    }

    /** The acceleration of a body by forces. */
    BigDecimal[] forced(OracleBody body) {
        BigDecimal inverse = body.inverseMass();
        return body.mass == null ? new BigDecimal[] {BigDecimal.ZERO, BigDecimal.ZERO}
            : new BigDecimal[] {Decimals.of(forces.forceX()).multiply(inverse).add(Decimals.of(forces.gravityX())),
                Decimals.of(forces.forceY()).multiply(inverse).add(Decimals.of(forces.gravityY()))};
    }

    /** True if a body touches a rim so flatly that it slides, where bodies rest. */
    boolean slides(OracleBody body, Wall wall) {
        if (!(wall instanceof Arena arena) || !law.bodiesRest()) {
            return false;
        }
        BigDecimal[] n = OracleWallGeometry.normal(body, wall);
        BigDecimal out = Decimals.dot(n[0], n[1], body.vx, body.vy);
        BigDecimal square = Decimals.dot(body.vx, body.vy, body.vx, body.vy);
        BigDecimal room = Decimals.of(arena.radius()).subtract(body.radius);
        return room.signum() > 0 && square.signum() > 0
            && (out.abs().multiply(room).multiply(TWO).compareTo(square.multiply(CHORD)) <= 0
            || Decimals.square(out).compareTo(square.multiply(Decimals.square(FLAT))) <= 0);
    }

    /**
     * Returns a body to its flight. Lifted off its support for more than a turn, it is accelerated by the whole force
     * again and keeps its energy: of the speed u with which it is lifted (u^2 - h^2 s (1 - s))^(1/2) is left, h being
     * the acceleration that the support has carried.
     */
    void leave(OracleBody body, BigDecimal vx, BigDecimal vy, BigDecimal at) {
        BigDecimal[] a = forced(body);
        BigDecimal heldX = a[0].subtract(body.ax);
        BigDecimal heldY = a[1].subtract(body.ay);
        BigDecimal held = Decimals.dot(heldX, heldY, heldX, heldY);
        BigDecimal lifted = Decimals.dot(heldX, heldY, vx.subtract(body.vx), vy.subtract(body.vy));
        if (lifted.multiply(TWO).compareTo(held) > 0) {
            BigDecimal left = Decimals.square(lifted)
                .subtract(Decimals.square(held).multiply(QUARTER.subtract(Decimals.square(at))));
            BigDecimal share = Decimals.divide(lifted.subtract(Decimals.root(left.max(BigDecimal.ZERO))), held);
            body.vx = Decimals.round(body.vx.add(heldX.multiply(share)));
            body.vy = Decimals.round(body.vy.add(heldY.multiply(share)));
            body.ax = a[0];
            body.ay = a[1];
        }
        body.accelerate(at.negate());
    }

    /** Takes what the flights of two still approach. @return the impulse */
    BigDecimal stop(List<OracleBody> bodies, int a, int b) {
        BigDecimal left = approach(bodies, a, b, BigDecimal.ZERO);
        if (left.signum() <= 0) {
            return BigDecimal.ZERO;
        }
        OracleBody p = bodies.get(a);
        OracleBody q = b < 0 ? null : bodies.get(b);
        BigDecimal impulse = Decimals.divide(left, q == null ? p.inverseMass() : p.inverseMass().add(q.inverseMass()));
        BigDecimal[] n = normal(bodies, a, b);
        p.push(impulse.negate(), n[0], n[1]);
        if (q != null) {
            q.push(impulse, n[0], n[1]);
        }
        return impulse;
    }
}
