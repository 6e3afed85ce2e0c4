package steward.game.meanmax;

import steward.physics.Bodies;
import steward.physics.PhysicsParts;
import steward.physics.Reaction;
import steward.physics.Reaction.Verdict;
import steward.physics.TurnSink;
import steward.physics.event.OfficialLoop;

/**
 * Motion of the published Mean Max referee in its own expressions and their order. Impacts react one at a time;
 * touching units react even when they separate; the second half of an impulse is raised to {@value #MINIMUM} unless it
 * is nearly nothing, whatever its sign.
 *
 * <p>Caveat: two units on exactly the same point, for which the referee computes no numbers, get no impulse here.
 */
public final class OfficialMeanMax extends OfficialLoop {

    private static final int PAIR = 0;
    private static final int BORDER = 1;

    /** The least second half of an impulse, in units of mass times u per turn. */
    private static final double MINIMUM = 30;
    private static final double EPSILON = 1e-5;
    private static final int TANKER = UnitKind.TANKER.ordinal();

    private final Reaction reaction;

    /** @param parts of a Mean Max scene in the official arithmetic */
    public OfficialMeanMax(PhysicsParts parts) {
        super(parts, false);
        reaction = parts.reaction();
    }

    /** Offers are times from now. */
    @Override
    protected void look(Bodies bodies, double now) {
        int size = bodies.size();
        for (int i = 0; i < size; i++) {
            if (bodies.kind[i] != TANKER && lookAtBorder(bodies, i)) {
                return;
            }
            for (int j = i + 1; j < size; j++) {
                if (lookAtPair(bodies, i, j)) {
                    return;
                }
            }
        }
    }

    /** @return whether the impact is now: no other comes before it */
    private boolean lookAtBorder(Bodies bodies, int i) {
        double x = bodies.x[i];
        double y = bodies.y[i];
        double radius = bodies.radius[i];
        double squared = x * x + y * y;
        if (Math.sqrt(squared) + radius >= MeanMaxWorld.ARENA_RADIUS) {
            offer(0, BORDER, bodies.id(i), ~0);
            return true;
        }
        double vx = bodies.vx[i];
        double vy = bodies.vy[i];
        double a = vx * vx + vy * vy;
        if (vx == 0 && vy == 0 || a <= 0) {
            return false;
        }
        double b = 2.0 * (x * vx + y * vy);
        double c = squared - (MeanMaxWorld.ARENA_RADIUS - radius) * (MeanMaxWorld.ARENA_RADIUS - radius);
        double discriminant = b * b - 4.0 * a * c;
        if (discriminant > 0) {
            double until = (-b + Math.sqrt(discriminant)) / (2.0 * a);
            if (until > 0) {
                offer(until, BORDER, bodies.id(i), ~0);
            }
        }
        return false;
    }

    /** @return whether the impact is now: no other comes before it */
    private boolean lookAtPair(Bodies bodies, int i, int j) {
        double x = bodies.x[i] - bodies.x[j];
        double y = bodies.y[i] - bodies.y[j];
        double touch = bodies.radius[i] + bodies.radius[j];
        double squared = x * x + y * y;
        if (Math.sqrt(squared) <= touch) {
            offer(0, PAIR, bodies.id(i), bodies.id(j));
            return true;
        }
        double vx = bodies.vx[i] - bodies.vx[j];
        double vy = bodies.vy[i] - bodies.vy[j];
        double a = vx * vx + vy * vy;
        if (a <= 0) {
            return false;
        }
        double b = 2.0 * (x * vx + y * vy);
        double c = squared - touch * touch;
        double discriminant = b * b - 4.0 * a * c;
        if (!(discriminant < 0)) {
            double until = (-b - Math.sqrt(discriminant)) / (2.0 * a);
            if (until > 0) {
                offer(until, PAIR, bodies.id(i), bodies.id(j));
            }
        }
        return false;
    }

    @Override
    protected boolean isInTurn(double now, double time) {
        return time + now <= 1.0;
    }

    @Override
    protected double fly(Bodies bodies, double now, double time) {
        move(bodies, time);
        return now + time;
    }

    @Override
    protected void react(Bodies bodies, double now, double time, int kind, int a, int b, TurnSink sink) {
        int i = bodies.indexOf(a);
        if (kind == BORDER) {
            reactBorder(bodies, i, now, sink);
            return;
        }
        int j = bodies.indexOf(b);
        boolean asks = bodies.kind[i] == TANKER ? bodies.kind[j] == UnitKind.DESTROYER.ordinal()
            : bodies.kind[j] == TANKER && bodies.kind[i] == UnitKind.DESTROYER.ordinal();
        if (asks) {
            sink.knot(a, now, bodies.x[i], bodies.y[i]);
            sink.knot(b, now, bodies.x[j], bodies.y[j]);
        }
        if (!asks || reaction.on(now, i, j, bodies, sink) == Verdict.BOUNCE) {
            reactPair(bodies, i, j, now, sink);
        }
    }

    private static void reactPair(Bodies bodies, int a, int b, double now, TurnSink sink) {
        double massA = bodies.mass[a];
        double massB = bodies.mass[b];
        double ax = bodies.x[a];
        double ay = bodies.y[a];
        double bx = bodies.x[b];
        double by = bodies.y[b];
        double vax = bodies.vx[a];
        double vay = bodies.vy[a];
        double vbx = bodies.vx[b];
        double vby = bodies.vy[b];
        double nx = ax - bx;
        double ny = ay - by;
        double squared = nx * nx + ny * ny;
        double distance = Math.sqrt(squared);
        double inverse = (massA + massB) / (massA * massB);
        double p = squared == 0 ? 0 : (nx * (vax - vbx) + ny * (vay - vby)) / (squared * inverse);
        double fx = nx * p;
        double fy = ny * p;
        double wa = 1.0 / massA;
        double wb = 1.0 / massB;
        bodies.vx[a] = vax - fx * wa;
        bodies.vy[a] = vay - fy * wa;
        bodies.vx[b] = vbx + fx * wb;
        bodies.vy[b] = vby + fy * wb;
        fx = fx * 0.5;
        fy = fy * 0.5;
        double raise = raise(fx, fy);
        fx = fx * raise;
        fy = fy * raise;
        bodies.vx[a] -= fx * wa;
        bodies.vy[a] -= fy * wa;
        bodies.vx[b] += fx * wb;
        bodies.vy[b] += fy * wb;
        double first = -p * distance;
        double second = first * 0.5 * raise;
        sink.impact(now, bodies.id(a), bodies.id(b), ax, ay, bx, by, unit(-nx, distance, 1), unit(-ny, distance, 0),
            first + second, inverse * (second * second - first * first) / 2, massA, massB, vax, vay, bodies.vx[a],
            bodies.vy[a], vbx, vby, bodies.vx[b], bodies.vy[b]);
        sink.knot(bodies.id(a), now, ax, ay);
        sink.knot(bodies.id(b), now, bx, by);
        double half = (distance - bodies.radius[a] - bodies.radius[b]) / 2.0;
        if (half <= 0) {
            moveTo(bodies, a, bx, by, half - EPSILON, now, sink);
            moveTo(bodies, b, bodies.x[a], bodies.y[a], half - EPSILON, now, sink);
        }
    }

    private static void reactBorder(Bodies bodies, int a, double now, TurnSink sink) {
        double mass = bodies.mass[a];
        double x = bodies.x[a];
        double y = bodies.y[a];
        double vx = bodies.vx[a];
        double vy = bodies.vy[a];
        double inverse = 1.0 / mass;
        double squared = x * x + y * y;
        double distance = Math.sqrt(squared);
        double p = (x * vx + y * vy) / (squared * inverse);
        double fx = x * p;
        double fy = y * p;
        bodies.vx[a] = vx - fx * inverse;
        bodies.vy[a] = vy - fy * inverse;
        fx = fx * 0.5;
        fy = fy * 0.5;
        double raise = raise(fx, fy);
        fx = fx * raise;
        fy = fy * raise;
        bodies.vx[a] -= fx * inverse;
        bodies.vy[a] -= fy * inverse;
        double nx = unit(x, distance, 1);
        double ny = unit(y, distance, 0);
        double first = p * distance;
        double second = first * 0.5 * raise;
        sink.impact(now, bodies.id(a), ~0, x, y, nx * MeanMaxWorld.ARENA_RADIUS, ny * MeanMaxWorld.ARENA_RADIUS,
            nx, ny, first + second, inverse * (second * second - first * first) / 2, mass,
            Double.POSITIVE_INFINITY, vx, vy, bodies.vx[a], bodies.vy[a], 0, 0, 0, 0);
        sink.knot(bodies.id(a), now, x, y);
        double beyond = distance + bodies.radius[a] - MeanMaxWorld.ARENA_RADIUS;
        if (beyond >= 0) {
            moveTo(bodies, a, 0, 0, beyond + EPSILON, now, sink);
        }
    }

    /** The factor that raises the second half of an impulse to its minimum. */
    private static double raise(double fx, double fy) {
        double length = Math.sqrt(fx * fx + fy * fy);
        return length > EPSILON && length < MINIMUM ? MINIMUM / length : 1.0;
    }

    private static double unit(double component, double length, double whenZero) {
        return length == 0 ? whenZero : component / length;
    }

    private static void moveTo(Bodies bodies, int body, double x, double y, double by, double now, TurnSink sink) {
        double dx = x - bodies.x[body];
        double dy = y - bodies.y[body];
        double distance = Math.sqrt(dx * dx + dy * dy);
        if (!(distance < EPSILON)) {
            double share = by / distance;
            bodies.x[body] += dx * share;
            bodies.y[body] += dy * share;
            sink.knot(bodies.id(body), now, bodies.x[body], bodies.y[body]);
        }
    }
}
