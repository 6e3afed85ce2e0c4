package steward.physics.queue;

import static steward.physics.queue.Crowd.RADIUS;
import static steward.physics.queue.Crowd.VX;
import static steward.physics.queue.Crowd.VY;
import static steward.physics.queue.Crowd.X;
import static steward.physics.queue.Crowd.Y;

import steward.physics.Bodies;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.TurnSink;
import steward.physics.Wall;
import steward.physics.impulse.Collision;
import steward.physics.impulse.ContactResponse;
import steward.physics.time.LowParts;

/**
 * The response to a contact in {@link QueueAdvance}, as {@link ContactResponse}, although only the bodies of the
 * contact have been moved to the present time.
 */
abstract class QueueContactResponse {

    final Crowd crowd;

    QueueContactResponse(Crowd crowd) {
        this.crowd = crowd;
    }

    /** Begins a turn with these bodies. */
    abstract void begin(Bodies bodies, TurnSink sink);

    /**
     * Responds to a contact; its bodies have been moved to this time.
     *
     * @param b another body, or {@code ~wall}
     * @return whether only these two have changed, so that all other predictions hold
     */
    abstract boolean react(int a, int b, double now);

    /** @param rounded receives the low parts of coordinates, or {@code null} where there are none */
    static QueueContactResponse of(Crowd crowd, PhysicsParts parts, Collision collision, LowParts rounded,
                         Wall[] walls) {
        return parts.reaction() == null && !parts.forces().act()
            ? new Bounce(crowd, collision, rounded, parts.law().restitution() == ImpactLaw.Restitution.MINIMUM)
            : new Ask(crowd, ContactResponse.of(parts, collision, walls), rounded);
    }

    /**
     * Updates position and velocity of a body after a reaction; after a positional correction its cell is found anew.
     */
    final void updateState(int body, double x, double y, double vx, double vy) {
        double[] state = crowd.state;
        int at = 8 * body;
        state[at + VX] = vx;
        state[at + VY] = vy;
        boolean pushed = state[at + X] != x || state[at + Y] != y;
        if (pushed || crowd.isOutside(body)) {
            crowd.removeFromCell(body);
            state[at + X] = x;
            state[at + Y] = y;
            crowd.assignCell(body);
        }
    }

    /**
     * Every contact is an impact. The two bodies are copied to a {@link Bodies} of two, so that only their own cache
     * lines are read.
     */
    static final class Bounce extends QueueContactResponse {

        private final Collision collision;
        private final LowParts rounded;
        private final boolean copiesRestitution;
        private final Bodies pair = new Bodies(2);
        private final IdRestoringSink idSink = new IdRestoringSink();
        private Bodies bodies;
        private TurnSink sink;

        Bounce(Crowd crowd, Collision collision, LowParts rounded, boolean copiesRestitution) {
            super(crowd);
            this.collision = collision;
            this.rounded = rounded;
            this.copiesRestitution = copiesRestitution;
            pair.add(0, 0, 1, 1);
            pair.add(0, 0, 1, 1);
            if (rounded != null) {
                rounded.ensureCapacity(2);
            }
        }

        @Override
        void begin(Bodies ofTurn, TurnSink of) {
            bodies = ofTurn;
            idSink.sink = of;
            sink = of == TurnSink.NONE ? of : idSink;
        }

        @Override
        boolean react(int a, int b, double now) {
            copy(a, 0);
            idSink.first = crowd.id[a];
            if (b >= 0) {
                copy(b, 1);
                idSink.second = crowd.id[b];
                collision.reactPair(pair, 0, 1, now, sink);
                updateState(b, pair.x[1], pair.y[1], pair.vx[1], pair.vy[1]);
            } else {
                collision.reactWall(pair, 0, ~b, now, sink);
            }
            updateState(a, pair.x[0], pair.y[0], pair.vx[0], pair.vy[0]);
            return true;
        }

        private void copy(int body, int to) {
            double[] state = crowd.state;
            int at = 8 * body;
            pair.x[to] = state[at + X];
            pair.y[to] = state[at + Y];
            pair.vx[to] = state[at + VX];
            pair.vy[to] = state[at + VY];
            pair.radius[to] = state[at + RADIUS];
            pair.mass[to] = crowd.mass[body];
            pair.inverseMass[to] = 1 / crowd.mass[body];
            if (rounded != null) {
                crowd.copyLowParts(body, rounded, to);
            }
            if (copiesRestitution) {
                pair.restitution[to] = bodies.restitution[crowd.index[body]];
            }
        }
    }

    /** Replaces the ids of the two copies by those of the bodies. */
    private static final class IdRestoringSink implements TurnSink {

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

    /**
     * For scenes with {@code ASK} contacts: before the reaction is called, all bodies are moved to the present time.
     */
    static final class Ask extends QueueContactResponse {

        private final ContactResponse response;
        private final LowParts rounded;
        private Bodies bodies;
        private TurnSink sink;

        Ask(Crowd crowd, ContactResponse response, LowParts rounded) {
            super(crowd);
            this.response = response;
            this.rounded = rounded;
        }

        @Override
        void begin(Bodies ofTurn, TurnSink of) {
            bodies = ofTurn;
            sink = of;
            if (rounded != null) {
                rounded.ensureCapacity(ofTurn.capacity());
            }
        }

        @Override
        boolean react(int a, int b, double now) {
            int i = crowd.index[a];
            int j = b < 0 ? b : crowd.index[b];
            if (response.needsAll(bodies, i, j)) {
                crowd.store(bodies, now);
            } else {
                crowd.store(a, bodies, now);
                if (b >= 0) {
                    crowd.store(b, bodies, now);
                }
            }
            if (rounded != null) {
                crowd.copyLowParts(a, rounded, i);
                if (b >= 0) {
                    crowd.copyLowParts(b, rounded, j);
                }
            }
            if (!response.reactAlone(bodies, i, j, now, sink)) {
                return false;
            }
            updateState(a, bodies.x[i], bodies.y[i], bodies.vx[i], bodies.vy[i]);
            if (b >= 0) {
                updateState(b, bodies.x[j], bodies.y[j], bodies.vx[j], bodies.vy[j]);
            }
            return true;
        }
    }
}
