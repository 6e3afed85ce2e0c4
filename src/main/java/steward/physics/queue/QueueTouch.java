package steward.physics.queue;

import static steward.physics.queue.Crowd.MASS;
import static steward.physics.queue.Crowd.RADIUS;
import static steward.physics.queue.Crowd.VX;
import static steward.physics.queue.Crowd.VY;
import static steward.physics.queue.Crowd.X;
import static steward.physics.queue.Crowd.Y;

import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.TurnSink;
import steward.physics.Wall;
import steward.physics.impulse.Collision;
import steward.physics.impulse.Touch;
import steward.physics.time.LowParts;

/** Lets two of a crowd react as {@link Touch} would, though the others are not in their places. */
abstract class QueueTouch {

    final Crowd crowd;

    QueueTouch(Crowd crowd) {
        this.crowd = crowd;
    }

    /** A turn with these bodies. */
    abstract void begin(Bodies bodies, TurnSink sink);

    /**
     * Two that have flown to this time react.
     *
     * @param b another, or {@code ~wall}
     * @return whether only these two have changed, and nobody else need look anew
     */
    abstract boolean happens(int a, int b, double now);

    /** @param rounded is told what rounded coordinates lack, or {@code null} if nobody wants to know */
    static QueueTouch of(Crowd crowd, PhysicsParts parts, Collision collision, LowParts rounded,
                         Wall[] walls) {
        return parts.reaction() == null
            ? new Bounce(crowd, collision, rounded, parts.law().restitution() == ImpactLaw.Restitution.MINIMUM)
            : new Ask(crowd, Touch.of(parts, collision, walls), rounded, parts.contacts());
    }

    /** Takes over where a body is and how fast after a reaction; one that was pushed finds its cell anew. */
    final void change(int body, double x, double y, double vx, double vy) {
        double[] state = crowd.state;
        int at = 8 * body;
        state[at + VX] = vx;
        state[at + VY] = vy;
        boolean pushed = state[at + X] != x || state[at + Y] != y;
        if (pushed || crowd.isOutside(body)) {
            crowd.unsettle(body);
            state[at + X] = x;
            state[at + Y] = y;
            crowd.settle(body);
        }
    }

    /** Every touch is an impact. The two are copied to a place of their own, so that only their own lines are read. */
    static final class Bounce extends QueueTouch {

        private final Collision collision;
        private final LowParts rounded;
        private final boolean restitutions;
        private final Bodies two = new Bodies(2);
        private final Named named = new Named();
        private Bodies bodies;
        private TurnSink sink;

        Bounce(Crowd crowd, Collision collision, LowParts rounded, boolean restitutions) {
            super(crowd);
            this.collision = collision;
            this.rounded = rounded;
            this.restitutions = restitutions;
            two.add(0, 0, 1, 1);
            two.add(0, 0, 1, 1);
            if (rounded != null) {
                rounded.room(2);
            }
        }

        @Override
        void begin(Bodies ofTurn, TurnSink of) {
            bodies = ofTurn;
            named.sink = of;
            sink = of == TurnSink.NONE ? of : named;
        }

        @Override
        boolean happens(int a, int b, double now) {
            copy(a, 0);
            named.first = bodies.id(crowd.index[a]);
            if (b >= 0) {
                copy(b, 1);
                named.second = bodies.id(crowd.index[b]);
                collision.reactPair(two, 0, 1, now, sink);
                change(b, two.x[1], two.y[1], two.vx[1], two.vy[1]);
            } else {
                collision.reactWall(two, 0, ~b, now, sink);
            }
            change(a, two.x[0], two.y[0], two.vx[0], two.vy[0]);
            return true;
        }

        private void copy(int body, int to) {
            double[] state = crowd.state;
            int at = 8 * body;
            two.x[to] = state[at + X];
            two.y[to] = state[at + Y];
            two.vx[to] = state[at + VX];
            two.vy[to] = state[at + VY];
            two.radius[to] = state[at + RADIUS];
            two.mass[to] = state[at + MASS];
            two.inverseMass[to] = 1 / state[at + MASS];
            if (rounded != null) {
                crowd.tell(body, rounded, to);
            }
            if (restitutions) {
                two.restitution[to] = bodies.restitution[crowd.index[body]];
            }
        }
    }

    /** Gives the two their ids back. */
    private static final class Named implements TurnSink {

        private TurnSink sink;
        private int first;
        private int second;

        @Override
        public void impact(double time, int a, int b, double ax, double ay, double bx, double by, double normalX,
                           double normalY, double impulse, double energy, double massA, double massB,
                           double vaxBefore, double vayBefore, double vaxAfter, double vayAfter,
                           double vbxBefore, double vbyBefore, double vbxAfter, double vbyAfter) {
            sink.impact(time, first, b < 0 ? b : second, ax, ay, bx, by, normalX, normalY, impulse, energy, massA,
                massB, vaxBefore, vayBefore, vaxAfter, vayAfter, vbxBefore, vbyBefore, vbxAfter, vbyAfter);
        }

        @Override
        public void knot(int bodyId, double time, double x, double y) {
            sink.knot(bodyId == 0 ? first : second, time, x, y);
        }
    }

    /** Contacts that ask: whoever is asked sees everybody in place. */
    static final class Ask extends QueueTouch {

        private final Touch touch;
        private final LowParts rounded;
        private final Contacts contacts;
        private Bodies bodies;
        private TurnSink sink;

        Ask(Crowd crowd, Touch touch, LowParts rounded, Contacts contacts) {
            super(crowd);
            this.touch = touch;
            this.rounded = rounded;
            this.contacts = contacts;
        }

        @Override
        void begin(Bodies ofTurn, TurnSink of) {
            bodies = ofTurn;
            sink = of;
            if (rounded != null) {
                rounded.room(ofTurn.capacity());
            }
        }

        @Override
        boolean happens(int a, int b, double now) {
            int i = crowd.index[a];
            int j = b < 0 ? b : crowd.index[b];
            Contacts.Meaning meaning = b < 0 ? contacts.withWall(bodies.kind[i])
                : contacts.between(bodies.kind[i], bodies.kind[j]);
            int passing = bodies.passing().size();
            if (meaning == Contacts.Meaning.ASK || passing > 0) {
                crowd.store(bodies, now);
            } else {
                crowd.store(a, bodies, now);
                if (b >= 0) {
                    crowd.store(b, bodies, now);
                }
            }
            if (rounded != null) {
                crowd.tell(a, rounded, i);
                if (b >= 0) {
                    crowd.tell(b, rounded, j);
                }
            }
            touch.flown(bodies);
            boolean alone = bodies.passing().size() == passing;
            if (!touch.happens(bodies, i, j, now, sink) || !alone) {
                return false;
            }
            change(a, bodies.x[i], bodies.y[i], bodies.vx[i], bodies.vy[i]);
            if (b >= 0) {
                change(b, bodies.x[j], bodies.y[j], bodies.vx[j], bodies.vy[j]);
            }
            return true;
        }
    }
}
