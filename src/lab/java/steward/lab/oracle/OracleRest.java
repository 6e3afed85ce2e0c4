package steward.lab.oracle;

import java.math.BigDecimal;
import java.util.List;
import steward.physics.Arena;
import steward.physics.Forces;
import steward.physics.ImpactLaw;
import steward.physics.Wall;

/**
 * The law of rest and of forces in the oracle's arithmetic, from its description in {@code docs/scenes.md}: of one
 * contact. Where more than one comes to rest at a time, or one in an arena, the oracle stops.
 */
final class OracleRest {

    /** The share of the radii up to which a gap is a contact, doubled: nearer than that the oracle stops. */
    private static final BigDecimal NEAR = Decimals.of(1 + 2.0 / 2048);
    private static final BigDecimal FEEBLE = Decimals.of(0x1p-40);
    private static final BigDecimal TWO = BigDecimal.valueOf(2);

    private final ImpactLaw law;
    private final List<Wall> walls;
    private final Forces forces;
    private boolean stopped;
    /** Of the contact that was looked at last. */
    private BigDecimal[] normal;
    private BigDecimal approach;
    private BigDecimal restitution;
    private OracleBody p;
    private OracleBody q;
    private BigDecimal half;

    OracleRest(ImpactLaw law, List<Wall> walls, Forces forces) {
        this.law = law;
        this.walls = walls;
        this.forces = forces;
    }

    /** True if the last contact is rest that the oracle does not compute. */
    boolean stopped() {
        return stopped;
    }

    /** Looks at a contact at a time of the turn, less a half. */
    void look(List<OracleBody> bodies, int a, int b, BigDecimal at) {
        stopped = false;
        half = at;
        p = bodies.get(a);
        q = b < 0 ? null : bodies.get(b);
        restitution = p.restitution.min(b < 0 ? Decimals.of(walls.get(~b).restitution()) : q.restitution);
        if (b < 0) {
            normal = OracleWallGeometry.normal(p, walls.get(~b));
        } else {
            BigDecimal dx = q.x.subtract(p.x);
            BigDecimal dy = q.y.subtract(p.y);
            BigDecimal distance = Decimals.length(dx, dy);
            normal = distance.signum() == 0 ? new BigDecimal[] {BigDecimal.ONE, BigDecimal.ZERO}
                : new BigDecimal[] {Decimals.divide(dx, distance), Decimals.divide(dy, distance)};
        }
        approach = along(p.vx, p.vy, q == null ? null : q.vx, q == null ? null : q.vy)
            .add(half.multiply(along(p.ax, p.ay, q == null ? null : q.ax, q == null ? null : q.ay)));
        p.most = p.most.max(twiceEnergy(p));
        if (q != null) {
            q.most = q.most.max(twiceEnergy(q));
        }
    }

    private static BigDecimal twiceEnergy(OracleBody body) {
        return body.energy().multiply(TWO);
    }

    private BigDecimal along(BigDecimal x, BigDecimal y, BigDecimal otherX, BigDecimal otherY) {
        return otherX == null ? Decimals.dot(normal[0], normal[1], x, y)
            : Decimals.dot(normal[0], normal[1], x.subtract(otherX), y.subtract(otherY));
    }

    private BigDecimal inverse() {
        return q == null ? p.inverseMass() : p.inverseMass().add(q.inverseMass());
    }

    /** True if the impact gives nothing back. */
    boolean isRest() {
        if (!law.bodiesRest() || law.separatingPairsReact() || restitution.compareTo(BigDecimal.ONE) >= 0) {
            return false;
        }
        BigDecimal rebound = restitution.multiply(approach);
        if (restitution.signum() == 0 || !Double.isNaN(law.restSpeed())) {
            return restitution.signum() == 0 || rebound.compareTo(Decimals.of(law.restSpeed())) <= 0;
        }
        BigDecimal force = square(p).max(q == null ? BigDecimal.ZERO : square(q));
        if (rebound.signum() <= 0
            || Decimals.atMost(Decimals.square(rebound.multiply(TWO)), force)) {
            return true;
        }
        BigDecimal least = q == null || q.mass == null ? p.most : p.mass == null ? q.most : p.most.min(q.most);
        return Decimals.square(approach).compareTo(FEEBLE.multiply(least).multiply(inverse())) < 0;
    }

    private BigDecimal square(OracleBody body) {
        BigDecimal[] a = forced(body);
        return Decimals.dot(a[0], a[1], a[0], a[1]);
    }

    private BigDecimal[] forced(OracleBody body) {
        BigDecimal inverse = body.inverseMass();
        return body.mass == null ? new BigDecimal[] {BigDecimal.ZERO, BigDecimal.ZERO}
            : new BigDecimal[] {Decimals.of(forces.forceX()).multiply(inverse).add(Decimals.of(forces.gravityX())),
                Decimals.of(forces.forceY()).multiply(inverse).add(Decimals.of(forces.gravityY()))};
    }

    /** True if the rest of this contact is computed here; without forces and restitution it is an ordinary impact. */
    boolean rests(List<OracleBody> bodies, int a, int b) {
        stopped = b < 0 && walls.get(~b) instanceof Arena || touches(bodies, a, b)
            || b >= 0 && bodies.get(b).mass != null && touches(bodies, b, a);
        return !stopped && (forces.act() || restitution.signum() > 0);
    }

    private boolean touches(List<OracleBody> bodies, int i, int partner) {
        OracleBody body = bodies.get(i);
        for (int k = 0; k < bodies.size(); k++) {
            OracleBody other = bodies.get(k);
            if (k != i && k != partner && OracleTimeOfImpact.within(body.x.subtract(other.x), body.y.subtract(other.y),
                body.radius.add(other.radius).multiply(NEAR))) {
                return true;
            }
        }
        for (int w = 0; w < walls.size() && body.mass != null; w++) {
            if (~w != partner && OracleWallGeometry.gap(body, walls.get(w))
                .compareTo(body.radius.multiply(NEAR.subtract(BigDecimal.ONE))) < 0) {
                return true;
            }
        }
        return false;
    }

    /** Takes the approach, and gives the bodies the flight and the acceleration of a contact that stays closed. */
    OracleImpact settle(OracleBody one, OracleBody other, int a, int b, BigDecimal time) {
        whole(one);
        if (other != null) {
            whole(other);
        }
        BigDecimal pressed = along(one.ax, one.ay, other == null ? null : other.ax, other == null ? null : other.ay);
        BigDecimal impulse = Decimals.divide(along(one.vx, one.vy, other == null ? null : other.vx,
            other == null ? null : other.vy), inverse());
        boolean closed = approach.multiply(TWO).add(pressed).signum() >= 0;
        impulse = closed ? impulse : impulse.max(BigDecimal.ZERO);
        push(impulse);
        if (closed && pressed.signum() > 0) {
            BigDecimal carried = Decimals.divide(pressed, inverse());
            carry(one, carried.negate());
            if (other != null) {
                carry(other, carried);
            }
        }
        OracleBody second = other == null ? one : other;
        return new OracleImpact(time, a, b, impulse, one.x, one.y, second.x, second.y, one.vx, one.vy,
            other == null ? BigDecimal.ZERO : other.vx, other == null ? BigDecimal.ZERO : other.vy);
    }

    /** Gives a body the whole acceleration of the forces, at the velocity that it now has. */
    private void whole(OracleBody body) {
        body.accelerate(half);
        BigDecimal[] a = forced(body);
        body.ax = a[0];
        body.ay = a[1];
        body.accelerate(half.negate());
    }

    private void push(BigDecimal impulse) {
        p.push(impulse.negate(), normal[0], normal[1]);
        if (q != null) {
            q.push(impulse, normal[0], normal[1]);
        }
    }

    private void carry(OracleBody body, BigDecimal force) {
        BigDecimal change = force.multiply(body.inverseMass());
        body.ax = Decimals.round(body.ax.add(change.multiply(normal[0])));
        body.ay = Decimals.round(body.ay.add(change.multiply(normal[1])));
    }

    /** Returns a body to its flight; lifted off its support for more than a turn, by the whole force. */
    void leave(OracleBody body, BigDecimal vx, BigDecimal vy, BigDecimal at) {
        BigDecimal[] a = forced(body);
        BigDecimal heldX = a[0].subtract(body.ax);
        BigDecimal heldY = a[1].subtract(body.ay);
        if (TWO.multiply(Decimals.dot(heldX, heldY, vx.subtract(body.vx), vy.subtract(body.vy)))
            .compareTo(Decimals.dot(heldX, heldY, heldX, heldY)) > 0) {
            body.ax = a[0];
            body.ay = a[1];
        }
        body.accelerate(at.negate());
    }

    /** Takes what the flights of the last contact still approach. @return the impulse */
    BigDecimal stop() {
        BigDecimal left = along(p.vx, p.vy, q == null ? null : q.vx, q == null ? null : q.vy);
        if (left.signum() <= 0) {
            return BigDecimal.ZERO;
        }
        BigDecimal impulse = Decimals.divide(left, inverse());
        push(impulse);
        return impulse;
    }
}
