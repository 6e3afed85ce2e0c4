package steward.lab.oracle;

import java.math.BigDecimal;
import java.util.List;
import steward.physics.ImpactLaw;
import steward.physics.Wall;
import steward.physics.impulse.Rest;

/**
 * Impact in the oracle's arithmetic: the first step of the impulse stops the approach, the second gives back the share
 * e of it or the law's minimum, and then comes the push-out. Source: the description of the impulse in the law ({@link
 * ImpactLaw}); conservation of momentum and energy follows and is tested.
 */
final class OracleReaction {

    private static final BigDecimal NEAR = Decimals.of(2.0 / Rest.NEAR);

    private final ImpactLaw law;
    private final List<Wall> walls;
    /** True if the last impact is rest if its bodies belong to a heap. */
    private boolean rests;

    OracleReaction(ImpactLaw law, List<Wall> walls) {
        this.law = law;
        this.walls = walls;
    }

    /** Bodies a and b react, b being {@code ~w} for a wall. @return {@code null} if there was nothing to react to */
    OracleImpact react(List<OracleBody> bodies, int a, int b, BigDecimal time) {
        return b < 0 ? withWall(bodies.get(a), a, b, time) : pair(bodies.get(a), bodies.get(b), a, b, time);
    }

    /** True if the impact that has just reacted is rest by the law: something else touches its bodies, or nearly. */
    boolean wasRest(List<OracleBody> bodies, int a, int b) {
        return rests && (touches(bodies, a, b) || b >= 0 && touches(bodies, b, a));
    }

    /** True if a body touches anything but its partner, by twice the gap that {@link Rest} takes for none. */
    private boolean touches(List<OracleBody> bodies, int i, int partner) {
        OracleBody body = bodies.get(i);
        for (int k = 0; k < bodies.size(); k++) {
            OracleBody other = bodies.get(k);
            if (k != i && k != partner && OracleTimeOfImpact.within(body.x.subtract(other.x), body.y.subtract(other.y),
                body.radius.add(other.radius).multiply(NEAR.add(BigDecimal.ONE)))) {
                return true;
            }
        }
        for (int w = 0; w < walls.size() && body.mass != null; w++) {
            if (~w != partner && OracleWallGeometry.gap(body, walls.get(w)).compareTo(body.radius.multiply(NEAR)) < 0) {
                return true;
            }
        }
        return false;
    }

    private OracleImpact pair(OracleBody p, OracleBody q, int a, int b, BigDecimal time) {
        BigDecimal dx = q.x.subtract(p.x);
        BigDecimal dy = q.y.subtract(p.y);
        BigDecimal distance = Decimals.length(dx, dy);
        boolean apart = distance.signum() > 0;
        BigDecimal nx = apart ? Decimals.divide(dx, distance) : BigDecimal.ONE;
        BigDecimal ny = apart ? Decimals.divide(dy, distance) : BigDecimal.ZERO;
        BigDecimal approach = Decimals.dot(nx, ny, p.vx.subtract(q.vx), p.vy.subtract(q.vy));
        BigDecimal first = Decimals.divide(approach, p.inverseMass().add(q.inverseMass()));
        BigDecimal restitution = p.restitution.min(q.restitution);
        rests = mayRest(Math.max(p.impacts++, q.impacts++), restitution, approach);
        BigDecimal impulse = first.add(second(first, restitution, true));
        BigDecimal ax = p.x;
        BigDecimal ay = p.y;
        BigDecimal bx = q.x;
        BigDecimal by = q.y;
        p.push(impulse.negate(), nx, ny);
        q.push(impulse, nx, ny);
        BigDecimal touch = p.radius.add(q.radius);
        if (!Double.isNaN(law.pushOut()) && OracleTimeOfImpact.within(dx, dy, touch)) {
            BigDecimal both = touch.subtract(distance).add(Decimals.of(law.pushOut()).multiply(BigDecimal.valueOf(2)));
            BigDecimal each = both.divide(BigDecimal.valueOf(2));
            shift(p, q.mass == null ? both.negate() : each.negate(), nx, ny);
            shift(q, p.mass == null ? both : each, nx, ny);
        }
        return new OracleImpact(time, a, b, impulse, ax, ay, bx, by, p.vx, p.vy, q.vx, q.vy);
    }

    private OracleImpact withWall(OracleBody body, int a, int b, BigDecimal time) {
        Wall wall = walls.get(~b);
        BigDecimal[] n = OracleWallGeometry.normal(body, wall);
        BigDecimal approach = Decimals.dot(n[0], n[1], body.vx, body.vy);
        rests = false;
        if (approach.signum() <= 0) {
            return null;
        }
        BigDecimal first = approach.multiply(body.mass);
        BigDecimal restitution = body.restitution.min(Decimals.of(wall.restitution()));
        rests = mayRest(body.impacts++, restitution, approach);
        BigDecimal impulse = first.add(second(first, restitution, law.minimumImpulseAtWalls()));
        BigDecimal ax = body.x;
        BigDecimal ay = body.y;
        BigDecimal gap = OracleWallGeometry.gap(body, wall);
        body.push(impulse.negate(), n[0], n[1]);
        if (!Double.isNaN(law.pushOut()) && gap.subtract(Decimals.SAME.multiply(body.radius)).signum() <= 0) {
            shift(body, gap.subtract(Decimals.of(law.pushOut()).multiply(BigDecimal.valueOf(2))), n[0], n[1]);
        }
        return new OracleImpact(time, a, b, impulse, ax, ay, ax, ay, body.vx, body.vy, BigDecimal.ZERO,
            BigDecimal.ZERO);
    }

    /** The rule of {@link Rest} for a body in a heap. */
    private boolean mayRest(int impacts, BigDecimal restitution, BigDecimal approach) {
        return law.bodiesRest() && restitution.compareTo(BigDecimal.ONE) < 0 && (Double.isNaN(law.restSpeed())
            ? restitution.signum() == 0 || impacts >= Rest.PATIENCE
            : restitution.multiply(approach).compareTo(Decimals.of(law.restSpeed())) <= 0);
    }

    /** e times the first step, raised to the minimum; or only in magnitude when it exceeds the dead zone. */
    private BigDecimal second(BigDecimal first, BigDecimal restitution, boolean withMinimum) {
        BigDecimal back = law.restitution() == ImpactLaw.Restitution.ELASTIC ? first : restitution.multiply(first);
        BigDecimal minimum = Decimals.of(law.minimumImpulse());
        if (!withMinimum || minimum.signum() == 0) {
            return back;
        }
        if (Double.isNaN(law.deadZone())) {
            return back.max(minimum);
        }
        boolean raised = back.abs().compareTo(Decimals.of(law.deadZone())) > 0 && back.abs().compareTo(minimum) < 0;
        return !raised ? back : back.signum() < 0 ? minimum.negate() : minimum;
    }

    private static void shift(OracleBody body, BigDecimal by, BigDecimal nx, BigDecimal ny) {
        if (body.mass != null) {
            body.move(nx.multiply(by), ny.multiply(by));
        }
    }
}
