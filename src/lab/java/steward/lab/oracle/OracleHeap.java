package steward.lab.oracle;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Function;
import steward.lab.oracle.OracleProjection.Condition;
import steward.physics.Arena;
import steward.physics.Wall;

/**
 * Heap that comes to rest, in the oracle's arithmetic, as {@code docs/scenes.md} describes it. It finds which bodies
 * hang together and which of them would meet before the turn ends. It computes the nearest velocities with which they
 * do not ({@link OracleProjection}), and the accelerations that closed contacts leave.
 */
final class OracleHeap {

    /** Gaps up to this share of the radii belong to a heap. */
    private static final BigDecimal NEAR = Decimals.of(1.0 / 2048);
    /** Gaps below this share of the radii are closed. */
    private static final BigDecimal CLOSED = Decimals.of(0x1p-24);
    /** A gap below this share of the radii is not used. */
    private static final BigDecimal ROUNDED = Decimals.of(0x1p-30);
    /** Share of a gap that is used until the end of the turn. */
    private static final BigDecimal USED = new BigDecimal("0.99");
    /** Share of the room by which a path ends inside a rim, if a closed gap is not less. */
    private static final BigDecimal INSIDE = Decimals.of(0x1p-40);
    /** The shortest rest of a turn that is divided by. */
    private static final BigDecimal LEAST_LEFT = Decimals.of(0x1p-20);
    /** Room for rounding in the threshold by forces. */
    private static final BigDecimal ROUNDING = Decimals.of(1 + 0x1p-30);
    /** Contacts part at this share of the speeds: which of two that are closed meets another first depends on it. */
    private static final BigDecimal PARTING = Decimals.of(0x1p-42);
    /** A path that ends nearer to its rim than this, as a share of the room, ends there. */
    private static final BigDecimal ON_RIM = BigDecimal.ONE.movePointLeft(40);
    private static final int MOST_ROUNDS = 400;
    private static final BigDecimal HALF = new BigDecimal("0.5");

    /** The most bodies of a heap that is computed: the effort grows with the third power. */
    private int most = Integer.MAX_VALUE;
    private final List<Wall> walls;
    private final OracleRest rest;
    private final OracleContacts contacts;
    private List<OracleBody> bodies;
    private final Set<Integer> heap = new LinkedHashSet<>();
    private int touching;
    /** Velocities of the instant. */
    private BigDecimal[] instantX;
    private BigDecimal[] instantY;
    private BigDecimal[] forceX;
    private BigDecimal[] forceY;
    private BigDecimal half;
    private BigDecimal left;
    private BigDecimal parting;
    private List<Condition> conditions;
    private OracleProjection nearest;
    /** Turns from the velocities that are sought to those of the instant. */
    private BigDecimal toInstant;
    /** True if the impact is no faster than forces make bodies at rest in half a turn. */
    private boolean calm;

    /** @param contacts what contacts mean; {@code null} if all are impacts */
    OracleHeap(List<Wall> walls, OracleRest rest, OracleContacts contacts) {
        this.walls = walls;
        this.rest = rest;
        this.contacts = contacts;
    }

    void limit(int bodiesAtMost) {
        most = bodiesAtMost;
    }

    /**
     * Lets the heap of an impact rest.
     *
     * @return its impacts; {@code null} if this is an ordinary impact; empty if there is no way to rest, or too many
     *         bodies
     */
    List<OracleImpact> settle(List<OracleBody> all, int a, int b, BigDecimal time) {
        bodies = all;
        half = time.subtract(HALF);
        left = BigDecimal.ONE.subtract(time).max(LEAST_LEFT);
        instantX = each(body -> body.vx.add(body.ax.multiply(half)));
        instantY = each(body -> body.vy.add(body.ay.multiply(half)));
        forceX = each(body -> rest.forced(body)[0]);
        forceY = each(body -> rest.forced(body)[1]);
        bodies.forEach(OracleBody::see);
        gather(a, b);
        boolean forced = rest.forced();
        if (!forced && touching == 1 && rest.restitution(bodies, a, b).signum() == 0) {
            return null;
        }
        if (heap.size() > most) {
            return List.of();
        }
        int low = b < 0 ? a : Math.min(a, b);
        int high = b < 0 ? b : Math.max(a, b);
        BigDecimal[] x = each(body -> body.vx);
        BigDecimal[] y = each(body -> body.vy);
        List<Condition> closed = List.of();
        if (forced) {
            calm = Decimals.atMost(Decimals.square(approach(low, high).multiply(BigDecimal.valueOf(2))
                .max(BigDecimal.ZERO)), rest.largest(bodies, a, b).multiply(Decimals.square(ROUNDING)));
            closed = time.signum() == 0 ? List.of() : closed(low, high);
            for (int i : heap) {
                x[i] = Decimals.round(instantX[i].subtract(forceX[i].multiply(half)));
                y[i] = Decimals.round(instantY[i].subtract(forceY[i].multiply(half)));
            }
        }
        toInstant = forced ? half : BigDecimal.ZERO;
        begin(x, y);
        conditions.add(contact(low, high, left));
        List<Condition> waiting = new ArrayList<>(closed);
        do {
            if (!meetAll(left)) {
                return List.of();
            }
        } while (holdsMore(waiting));
        for (int i : heap) {
            bodies.get(i).vx = x[i];
            bodies.get(i).vy = y[i];
            bodies.get(i).rested = true;
        }
        List<OracleImpact> impacts = exchange(time);
        if (forced && !carry(time)) {
            return List.of();
        }
        return impacts;
    }

    private BigDecimal[] each(Function<OracleBody, BigDecimal> of) {
        return bodies.stream().map(of).map(Decimals::round).toArray(BigDecimal[]::new);
    }

    private void begin(BigDecimal[] x, BigDecimal[] y) {
        nearest = new OracleProjection(bodies, x, y);
        conditions = new ArrayList<>();
        BigDecimal most = BigDecimal.ZERO;
        for (int i : heap) {
            most = most.max(x[i].abs()).max(y[i].abs());
        }
        parting = most.multiply(PARTING).negate();
    }

    private BigDecimal approach(int a, int b) {
        return contact(a, b, BigDecimal.ZERO).speed(instantX, instantY);
    }

    private BigDecimal gap(int a, int b) {
        OracleBody p = bodies.get(a);
        return b < 0 ? OracleWallGeometry.gap(p, walls.get(~b)) : Decimals.length(bodies.get(b).x.subtract(p.x),
            bodies.get(b).y.subtract(p.y)).subtract(p.radius).subtract(bodies.get(b).radius);
    }

    private BigDecimal radii(int a, int b) {
        return b < 0 ? bodies.get(a).radius : bodies.get(a).radius.add(bodies.get(b).radius);
    }

    /** The condition of a contact for a time; for none, and of a closed gap, that it parts. */
    private Condition contact(int a, int b, BigDecimal turns) {
        BigDecimal[] n = rest.normal(bodies, a, b);
        BigDecimal gap = gap(a, b);
        boolean open = turns.signum() > 0 && gap.compareTo(ROUNDED.multiply(radii(a, b))) > 0;
        return new Condition(a, b, n[0], n[1], open ? Decimals.divide(USED.multiply(gap), turns)
            : parting == null ? BigDecimal.ZERO : parting);
    }

    private boolean meet(int a, int b) {
        return contacts == null || contacts.alwaysBounce(a, b);
    }

    private boolean isRest(int a, int b, BigDecimal approach) {
        return rest.isRest(bodies, a, b, approach);
    }

    private void gather(int a, int b) {
        heap.clear();
        touching = 1;
        List<Integer> next = new ArrayList<>();
        boolean again = bodies.get(a).rested || b >= 0 && bodies.get(b).rested;
        BigDecimal share = again ? BigDecimal.ONE : NEAR;
        enter(next, a);
        if (b >= 0) {
            enter(next, b);
        }
        for (int k = 0; k < next.size() && heap.size() <= most; k++) {
            int i = next.get(k);
            for (int j = ~(walls.size() - 1); j < bodies.size(); j++) {
                boolean isPair = i == a && j == b || i == b && j == a;
                if (j != i && !isPair && meet(i, j) && gap(i, j).compareTo(share.multiply(radii(i, j))) <= 0
                    && isRest(i, j, approach(i, j))) {
                    touching++;
                    if (j >= 0) {
                        enter(next, j);
                    }
                }
            }
        }
    }

    private void enter(List<Integer> next, int i) {
        if (bodies.get(i).mass != null && heap.add(i)) {
            next.add(i);
        }
    }

    /** The contacts that forces would close again within a turn: those that carry half a turn later. */
    private List<Condition> closed(int a, int b) {
        BigDecimal[] x = new BigDecimal[instantX.length];
        BigDecimal[] y = new BigDecimal[x.length];
        for (int i = 0; i < x.length; i++) {
            x[i] = Decimals.round(instantX[i].add(forceX[i].multiply(HALF)));
            y[i] = Decimals.round(instantY[i].add(forceY[i].multiply(HALF)));
        }
        toInstant = HALF.negate();
        begin(x, y);
        conditions.add(contact(a, b, BigDecimal.ZERO));
        return meetAll(BigDecimal.ZERO) ? conditions.stream().filter(each -> each.impulse.signum() > 0).toList()
            : List.of();
    }

    /** Solves, and adds what would meet, until nothing does. @return false if that cannot be */
    private boolean meetAll(BigDecimal turns) {
        for (int round = 0; round < MOST_ROUNDS; round++) {
            if (!nearest.solve(conditions)) {
                return false;
            }
            List<Condition> met = met(turns);
            conditions.addAll(met);
            boolean turned = turns.signum() > 0 && turnRims();
            if (met.isEmpty() && !turned) {
                return true;
            }
        }
        return false;
    }

    private boolean isKnown(int a, int b) {
        return conditions.stream().anyMatch(each -> each.a == a && each.b == b);
    }

    private List<Condition> met(BigDecimal turns) {
        List<Condition> met = new ArrayList<>();
        for (int i : heap) {
            for (int j = 0; j < bodies.size(); j++) {
                boolean partner = heap.contains(j) ? j < i : bodies.get(j).mass == null;
                if (partner && meet(i, j) && !isKnown(Math.min(i, j), Math.max(i, j)) && reaches(i, j, turns)) {
                    addIfRest(met, contact(Math.min(i, j), Math.max(i, j), turns));
                }
            }
            for (int w = 0; w < walls.size(); w++) {
                if (isKnown(i, ~w) || !meet(i, ~w)) {
                    continue;
                }
                boolean rim = turns.signum() > 0 && walls.get(w) instanceof Arena;
                Condition condition = rim ? rim(i, w) : contact(i, ~w, turns);
                if (rim ? excess(condition).signum() > 0 : reaches(i, ~w, turns)) {
                    addIfRest(met, condition);
                }
            }
        }
        return met;
    }

    private BigDecimal excess(Condition condition) {
        return condition.speed(nearest.x, nearest.y).subtract(condition.limit);
    }

    private void addIfRest(List<Condition> met, Condition next) {
        BigDecimal now = approach(next.a, next.b);
        if (isRest(next.a, next.b, now) && (calm && gap(next.a, next.b).compareTo(NEAR.multiply(radii(next.a, next.b)))
            <= 0 || isRest(next.a, next.b, next.speed(nearest.x, nearest.y)
            .add(toInstant.multiply(next.speed(forceX, forceY)))))) {
            met.add(next);
        }
    }

    /** True if two would meet within a time; in none, if they touch and approach. */
    private boolean reaches(int i, int j, BigDecimal turns) {
        Condition contact = contact(i, j, BigDecimal.ZERO);
        boolean approaches = contact.speed(nearest.x, nearest.y).compareTo(parting.negate()) > 0;
        BigDecimal gap = gap(i, j);
        if (turns.signum() == 0 || gap.signum() <= 0) {
            return approaches && gap.compareTo(CLOSED.multiply(radii(i, j))) <= 0;
        }
        OracleBody p = bodies.get(i);
        BigDecimal[] kept = {p.vx, p.vy};
        p.vx = nearest.x[i];
        p.vy = nearest.y[i];
        BigDecimal time = j < 0 ? OracleTimeOfImpact.wall(p, walls.get(~j)) : OracleTimeOfImpact.circle(
            p.x.subtract(bodies.get(j).x), p.y.subtract(bodies.get(j).y), nearest.x[i].subtract(nearest.x[j]),
            nearest.y[i].subtract(nearest.y[j]), p.radius.add(bodies.get(j).radius));
        p.vx = kept[0];
        p.vy = kept[1];
        return approaches && time != null && time.compareTo(turns) < 0;
    }

    /** The tangent of a rim where the path of a body ends. */
    private Condition rim(int i, int w) {
        Arena arena = (Arena) walls.get(w);
        OracleBody body = bodies.get(i);
        BigDecimal x = body.x.subtract(Decimals.of(arena.x()));
        BigDecimal y = body.y.subtract(Decimals.of(arena.y()));
        BigDecimal room = Decimals.of(arena.radius()).subtract(body.radius);
        BigDecimal margin = room.multiply(INSIDE).min(body.radius.multiply(ROUNDED).multiply(HALF));
        BigDecimal endX = x.add(nearest.x[i].multiply(left));
        BigDecimal endY = y.add(nearest.y[i].multiply(left));
        BigDecimal length = Decimals.length(endX, endY);
        BigDecimal nx = Decimals.divide(endX, length);
        BigDecimal ny = Decimals.divide(endY, length);
        return new Condition(i, ~w, nx, ny, Decimals.divide(room.subtract(margin)
            .subtract(Decimals.dot(nx, ny, x, y)), left));
    }

    /** Turns the tangents of rims to where paths now end. @return true if one has turned */
    private boolean turnRims() {
        boolean turned = false;
        for (Condition each : conditions) {
            if (each.b < 0 && walls.get(~each.b) instanceof Arena arena) {
                Condition now = rim(each.a, ~each.b);
                BigDecimal off = excess(now).multiply(left);
                BigDecimal least = ON_RIM.multiply(Decimals.of(arena.radius()));
                if (off.compareTo(least) > 0 || each.equal && off.compareTo(least.negate()) < 0) {
                    each.nx = now.nx;
                    each.ny = now.ny;
                    each.limit = now.limit;
                    turned = true;
                }
            }
        }
        return turned;
    }

    /** Keeps closed what would open. @return true if there is any */
    private boolean holdsMore(List<Condition> waiting) {
        List<Condition> opening = waiting.stream().filter(each -> {
            boolean rim = each.b < 0 && walls.get(~each.b) instanceof Arena;
            return rim ? excess(rim(each.a, ~each.b)).multiply(left).compareTo(
                ON_RIM.multiply(bodies.get(each.a).radius).negate()) < 0
                : each.speed(nearest.x, nearest.y).compareTo(parting.multiply(BigDecimal.valueOf(4))) < 0;
        }).toList();
        waiting.removeAll(opening);
        for (Condition each : opening) {
            boolean rim = each.b < 0 && walls.get(~each.b) instanceof Arena;
            Condition held = rim ? rim(each.a, ~each.b) : contact(each.a, each.b, BigDecimal.ZERO);
            held.equal = true;
            conditions.removeIf(known -> known.a == each.a && known.b == each.b);
            conditions.add(held);
        }
        return !opening.isEmpty();
    }

    private List<OracleImpact> exchange(BigDecimal time) {
        List<OracleImpact> impacts = new ArrayList<>();
        conditions.sort(Comparator.comparingInt((Condition each) -> each.a)
            .thenComparingLong(each -> each.b < 0 ? (1L << 32) + ~each.b : each.b));
        for (Condition each : conditions) {
            if (each.impulse.signum() != 0) {
                OracleBody p = bodies.get(each.a);
                OracleBody q = each.b < 0 ? null : bodies.get(each.b);
                p.push(each.impulse.negate(), each.nx, each.ny);
                if (q != null) {
                    q.push(each.impulse, each.nx, each.ny);
                }
                OracleBody second = q == null ? p : q;
                impacts.add(new OracleImpact(time, each.a, each.b, each.impulse, p.x, p.y, second.x, second.y, p.vx,
                    p.vy, q == null ? BigDecimal.ZERO : q.vx, q == null ? BigDecimal.ZERO : q.vy));
            }
        }
        return impacts;
    }

    /** Gives the heap the accelerations nearest to those of the forces that its contacts leave. */
    private boolean carry(BigDecimal time) {
        List<Condition> carrying = new ArrayList<>();
        for (Condition each : conditions) {
            boolean rim = each.b < 0 && walls.get(~each.b) instanceof Arena;
            boolean shut = each.equal || rim || each.limit.signum() <= 0;
            if (each.impulse.signum() == 0 && !each.equal || !shut && time.compareTo(HALF) >= 0) {
                continue;
            }
            carrying.add(new Condition(each.a, each.b, each.nx, each.ny, shut ? BigDecimal.ZERO
                : Decimals.divide(each.limit.subtract(each.speed(instantX, instantY)), half.negate())
                .max(BigDecimal.ZERO)));
            carrying.get(carrying.size() - 1).equal = each.equal;
        }
        OracleProjection accelerations = new OracleProjection(bodies, forceX, forceY);
        if (!accelerations.solve(carrying)) {
            return false;
        }
        for (int i : heap) {
            bodies.get(i).ax = accelerations.x[i];
            bodies.get(i).ay = accelerations.y[i];
        }
        return true;
    }
}
