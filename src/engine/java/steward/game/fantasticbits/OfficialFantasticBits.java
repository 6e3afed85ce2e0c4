package steward.game.fantasticbits;

import steward.physics.Bodies;
import steward.physics.PhysicsParts;
import steward.physics.TurnSink;
import steward.physics.event.OfficialLoop;

/**
 * Motion of the published Fantastic Bits referee in its own expressions and their order. Impacts within 1e-5 of the
 * earliest react together; touching bodies react even when they separate, with an impulse of at least {@value #MINIMUM}
 * in its second half. Bodies are never removed, so that indices are ids.
 */
public final class OfficialFantasticBits extends OfficialLoop {

    private static final int WALL = 0;
    private static final int PAIR = 1;
    private static final int CAPTURE = 2;
    private static final int GOAL = 3;

    private static final int LEFT = 0;
    private static final int TOP = 1;
    private static final int RIGHT = 2;
    private static final int BOTTOM = 3;

    /** The least second half of an impulse between bodies, in units of mass times u per turn. */
    private static final double MINIMUM = 100;
    private static final double EPSILON = 1e-5;
    private static final int SNAFFLE = EntityKind.SNAFFLE.ordinal();

    /** @param parts of a Fantastic Bits scene in the official arithmetic */
    public OfficialFantasticBits(PhysicsParts parts) {
        super(parts, true);
    }

    /** Offers are times from the beginning of the turn. */
    @Override
    protected void look(Bodies bodies, double now) {
        int bludger = Pitch.firstBludger(bodies);
        int post = Pitch.firstPost(bodies);
        for (int i = Pitch.WIZARDS - 1; i >= 0; i--) {
            lookAtWalls(bodies, i, now);
            lookAtPosts(bodies, i, post, now);
            for (int j = i - 1; j >= 0; j--) {
                lookAtPair(bodies, i, j, now);
            }
            if (!Captures.holds(bodies, i)) {
                lookAtSnaffles(bodies, i, bludger, now);
            }
        }
        for (int i = bludger - 1; i >= Pitch.WIZARDS; i--) {
            if (bodies.kind[i] == SNAFFLE) {
                lookAtPosts(bodies, i, post, now);
                if (!Pitch.isInGoal(bodies, i)) {
                    lookAtWalls(bodies, i, now);
                }
                for (int j = i - 1; j >= Pitch.WIZARDS; j--) {
                    if (bodies.kind[j] == SNAFFLE && !Pitch.ignores(bodies, i, j)) {
                        lookAtPair(bodies, i, j, now);
                    }
                }
                lookAtGoals(bodies, i, now);
            }
        }
        for (int i = post - 1; i >= bludger; i--) {
            lookAtWalls(bodies, i, now);
            lookAtPosts(bodies, i, post, now);
            for (int j = i - 1; j >= bludger; j--) {
                lookAtPair(bodies, i, j, now);
            }
            for (int j = 0; j < bludger; j++) {
                lookAtPair(bodies, i, j, now);
            }
        }
    }

    /** A wall that is touched reacts now; of the others the first that is reached. */
    private void lookAtWalls(Bodies bodies, int i, double now) {
        double radius = bodies.radius[i];
        double x = bodies.x[i];
        double y = bodies.y[i];
        double right = Pitch.WIDTH - radius;
        double bottom = Pitch.HEIGHT - radius;
        int touched = x < radius ? LEFT : x > right ? RIGHT : y < radius ? TOP : y > bottom ? BOTTOM : -1;
        if (touched >= 0) {
            offer(now, WALL, i, touched);
            return;
        }
        double vx = bodies.vx[i];
        double vy = bodies.vy[i];
        double least = Double.POSITIVE_INFINITY;
        int side = -1;
        if (vx != 0) {
            double until = vx > 0 ? (right - x) / vx : (radius - x) / vx;
            if (until >= 0 && !(bodies.kind[i] == SNAFFLE && Pitch.isInMouth(y + until * vy))) {
                least = until;
                side = vx > 0 ? RIGHT : LEFT;
            }
        }
        if (vy != 0) {
            double until = vy > 0 ? (bottom - y) / vy : (radius - y) / vy;
            if (until >= 0 && until < least) {
                least = until;
                side = vy > 0 ? BOTTOM : TOP;
            }
        }
        if (least <= 1 - now) {
            offer(now + least, WALL, i, side);
        }
    }

    /** Posts are bodies that never move. */
    private void lookAtPosts(Bodies bodies, int i, int post, double now) {
        for (int j = post; j < bodies.size(); j++) {
            lookAtPair(bodies, i, j, now);
        }
    }

    private void lookAtPair(Bodies bodies, int i, int j, double now) {
        double until = until(bodies, i, j, bodies.radius[i] + bodies.radius[j], now);
        if (until >= 0) {
            offer(now + until, PAIR, i, j);
        }
    }

    /** The nearest snaffle in reach is taken now; any other only when it comes into reach. */
    private void lookAtSnaffles(Bodies bodies, int wizard, int bludger, double now) {
        int nearest = Captures.nearest(bodies, wizard);
        if (nearest >= 0) {
            offer(now, CAPTURE, wizard, nearest);
        }
        for (int j = Pitch.WIZARDS; j < bludger; j++) {
            if (j != nearest && Captures.isCapturable(bodies, wizard, j)) {
                double until = until(bodies, wizard, j, Captures.REACH, now);
                if (until > 0) {
                    offer(now + until, CAPTURE, wizard, j);
                }
            }
        }
    }

    private void lookAtGoals(Bodies bodies, int i, double now) {
        double x = bodies.x[i];
        double vx = bodies.vx[i];
        if (x >= Pitch.WIDTH) {
            offer(now, GOAL, i, 0);
        } else if (x <= 0) {
            offer(now, GOAL, i, 1);
        } else if (vx != 0) {
            double right = (Pitch.WIDTH - x) / vx;
            double left = -x / vx;
            if (right <= 1 - now && right > 0) {
                offer(now + right, GOAL, i, 0);
            } else if (left <= 1 - now && left > 0) {
                offer(now + left, GOAL, i, 1);
            }
        }
    }

    /** The time until two are at a distance: 0 if they are within it, -1 if not in this turn. */
    private static double until(Bodies bodies, int i, int j, double touch, double now) {
        double vx = bodies.vx[i] - bodies.vx[j];
        double vy = bodies.vy[i] - bodies.vy[j];
        double x = bodies.x[i] - bodies.x[j];
        double y = bodies.y[i] - bodies.y[j];
        double squared = x * x + y * y;
        if (squared <= touch * touch) {
            return 0;
        }
        double a = vx * vx + vy * vy;
        double b = x * vx + y * vy;
        double c = squared - touch * touch;
        double discriminant = b * b - a * c;
        if (!(discriminant > 0) || a == 0) {
            return -1;
        }
        double root = Math.sqrt(discriminant);
        double until = Math.min((-b + root) / a, (-b - root) / a);
        return until <= 1 - now && until > 0 ? until : -1;
    }

    @Override
    protected boolean isInTurn(double now, double time) {
        return true;
    }

    @Override
    protected boolean isTogether(double earliest, double time) {
        return time <= earliest + EPSILON;
    }

    @Override
    protected double fly(Bodies bodies, double now, double time) {
        double step = time - now;
        if (step > 0) {
            move(bodies, step);
        }
        return now + step;
    }

    @Override
    protected boolean isOver(double now) {
        return now >= 1;
    }

    @Override
    protected void react(Bodies bodies, double now, double time, int kind, int a, int b, TurnSink sink) {
        switch (kind) {
            case CAPTURE -> Captures.capture(bodies, a, b, time, sink);
            case GOAL -> Captures.score(bodies, a, b, time, sink);
            case WALL -> reactWall(bodies, a, b, time, sink);
            default -> reactPair(bodies, a, b, time, sink);
        }
        if (kind == WALL || kind == PAIR) {
            Captures.afterImpact(bodies, a, kind == WALL ? ~b : b, time, sink);
        }
    }

    private static void reactWall(Bodies bodies, int a, int side, double time, TurnSink sink) {
        double x = bodies.x[a];
        double y = bodies.y[a];
        if (bodies.kind[a] != EntityKind.WIZARD.ordinal() && bodies.kind[a] != EntityKind.BLUDGER.ordinal()
            && Pitch.isInGoal(bodies, a)) {
            sink.fact(time, Captures.OPEN_GOAL, a, side, x, y, 0, 0);
            return;
        }
        boolean upright = side == LEFT || side == RIGHT;
        double mass = bodies.mass[a];
        double vx = bodies.vx[a];
        double vy = bodies.vy[a];
        double force = 2 * (upright ? vx : vy) * mass;
        push(bodies, a, (upright ? -1.0 : 0.0) * force, (upright ? 0.0 : -1.0) * force);
        double radius = bodies.radius[a];
        double sign = side == LEFT || side == TOP ? -1 : 1;
        sink.impact(time, a, ~side, x, y, upright ? x + sign * radius : x, upright ? y : y + sign * radius,
            upright ? sign : 0, upright ? 0 : sign, sign * force, 0, mass, Double.POSITIVE_INFINITY, vx, vy,
            bodies.vx[a], bodies.vy[a], 0, 0, 0, 0);
        sink.knot(a, time, x, y);
        bodies.x[a] = mirrored(x, radius, Pitch.WIDTH);
        bodies.y[a] = mirrored(y, radius, Pitch.HEIGHT);
        if (bodies.x[a] != x || bodies.y[a] != y) {
            sink.knot(a, time, bodies.x[a], bodies.y[a]);
        }
    }

    private static double mirrored(double place, double radius, double size) {
        double at = place;
        if (at > size - radius) {
            at += -2 * (at - (size - radius));
        }
        if (at < radius) {
            at += -2 * (at - radius);
        }
        return at;
    }

    private static void push(Bodies bodies, int a, double fx, double fy) {
        bodies.vx[a] += fx * bodies.inverseMass[a];
        bodies.vy[a] += fy * bodies.inverseMass[a];
    }

    /**
     * The second may be a post: its inverse mass is 0, and since masses are powers of two, the impulse has the bits of
     * the referee's expression for posts. Only the other is moved away then.
     */
    private static void reactPair(Bodies bodies, int a, int b, double time, TurnSink sink) {
        double ax = bodies.x[a];
        double ay = bodies.y[a];
        double bx = bodies.x[b];
        double by = bodies.y[b];
        double vax = bodies.vx[a];
        double vay = bodies.vy[a];
        double vbx = bodies.vx[b];
        double vby = bodies.vy[b];
        double dx = bx - ax;
        double dy = by - ay;
        double distance = Math.sqrt(dx * dx + dy * dy);
        double nx = distance == 0 ? 1 : dx / distance;
        double ny = distance == 0 ? 0 : dy / distance;
        double inverse = bodies.inverseMass[a] + bodies.inverseMass[b];
        double first = (nx * (vax - vbx) + ny * (vay - vby)) / inverse;
        double second = Math.max(MINIMUM, first);
        double impulse = first + second;
        double fx = nx * (-1 * impulse);
        double fy = ny * (-1 * impulse);
        push(bodies, a, fx, fy);
        push(bodies, b, fx * -1, fy * -1);
        sink.impact(time, a, b, ax, ay, bx, by, nx, ny, impulse, inverse * (second * second - first * first) / 2,
            bodies.mass[a], bodies.mass[b], vax, vay, bodies.vx[a], bodies.vy[a], vbx, vby, bodies.vx[b],
            bodies.vy[b]);
        sink.knot(a, time, ax, ay);
        sink.knot(b, time, bx, by);
        double gap = distance - bodies.radius[a] - bodies.radius[b];
        if (gap <= 0) {
            double half = -gap / 2 + EPSILON;
            shift(bodies, a, nx * -half, ny * -half, time, sink);
            if (bodies.inverseMass[b] > 0) {
                shift(bodies, b, nx * half, ny * half, time, sink);
            }
        }
    }

    private static void shift(Bodies bodies, int body, double dx, double dy, double time, TurnSink sink) {
        bodies.x[body] += dx;
        bodies.y[body] += dy;
        sink.knot(body, time, bodies.x[body], bodies.y[body]);
    }
}
