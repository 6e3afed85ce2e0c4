package steward.lab.oracle;

import java.math.BigDecimal;
import java.util.List;
import steward.physics.Forces;
import steward.physics.ImpactLaw;
import steward.physics.Wall;

/**
 * Reaction to an impact in the oracle's arithmetic. The first step of the impulse stops the approach, the second gives
 * back the share e of it or the law's minimum; then comes the push-out. Source: the description of the impulse in the
 * law ({@link ImpactLaw}); conservation of momentum and energy follows and is tested.
 */
final class OracleReaction {

    private static final BigDecimal HALF = new BigDecimal("0.5");

    private final ImpactLaw law;
    private final List<Wall> walls;
    private final boolean forced;
    private final OracleRest rest;
    /** {@code null} where all contacts are impacts. */
    private final OracleContacts contacts;
    private final OracleHeap heap;
    private boolean stopped;

    /** @param contacts what contacts mean; {@code null} if all are impacts */
    OracleReaction(ImpactLaw law, List<Wall> walls, Forces forces, OracleContacts contacts) {
        this.law = law;
        this.walls = walls;
        forced = forces.act() && !law.separatingPairsReact();
        rest = new OracleRest(law, walls, forces);
        this.contacts = contacts;
        heap = new OracleHeap(this.walls, rest, contacts);
    }

    /** Lets bodies a and b react, b being {@code ~w} for a wall. @return the impacts, if there are any */
    List<OracleImpact> react(List<OracleBody> bodies, int a, int b, BigDecimal time) {
        OracleBody p = bodies.get(a);
        OracleBody q = b < 0 ? null : bodies.get(b);
        BigDecimal half = time.subtract(HALF);
        stopped = b < 0 && rest.slides(p, walls.get(~b));
        p.see();
        if (q != null) {
            q.see();
        }
        if (!stopped && (contacts == null || contacts.alwaysBounce(a, b))
            && rest.isRest(bodies, a, b, rest.approach(bodies, a, b, half))) {
            List<OracleImpact> impacts = heap.settle(bodies, a, b, time);
            stopped = impacts != null && impacts.isEmpty();
            if (impacts != null) {
                return impacts;
            }
        }
        accelerate(p, q, half);
        BigDecimal[] before = {p.vx, p.vy, q == null ? BigDecimal.ZERO : q.vx, q == null ? BigDecimal.ZERO : q.vy};
        OracleImpact impact = b < 0 ? withWall(p, a, b, time) : pair(p, q, a, b, time);
        if (forced) {
            rest.leave(p, before[0], before[1], half);
            if (q != null) {
                rest.leave(q, before[2], before[3], half);
            }
            BigDecimal more = rest.stop(bodies, a, b);
            impact = impact == null ? null : impact.with(more, p, q);
        }
        return impact == null ? List.of() : List.of(impact);
    }

    private void accelerate(OracleBody p, OracleBody q, BigDecimal turns) {
        if (forced) {
            p.accelerate(turns);
            if (q != null) {
                q.accelerate(turns);
            }
        }
    }

    void limitHeaps(int bodies) {
        heap.limit(bodies);
    }

    /** True if the last contact slides or is rest that the oracle does not compute. */
    boolean stopped() {
        return stopped;
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
        BigDecimal impulse = approach.signum() <= 0 && forced ? BigDecimal.ZERO
            : first.add(second(first, restitution, true));
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
        if (approach.signum() <= 0 && !forced) {
            return null;
        }
        BigDecimal first = approach.max(BigDecimal.ZERO).multiply(body.mass);
        BigDecimal restitution = body.restitution.min(Decimals.of(wall.restitution()));
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
