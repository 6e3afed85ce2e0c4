package steward.physics.event.cells;

import steward.physics.Bodies;
import steward.physics.TurnSink;

/**
 * Copy of the two bodies of an impact in a {@link Bodies} of two, so that only their own lines of memory are read. It
 * is for scenes in which only these two have a part in an impact.
 */
final class PairCopy {

    private final Crowd crowd;
    private final boolean copiesRestitution;
    final Bodies pair = new Bodies(2);
    private final IdRestoringSink idSink = new IdRestoringSink();

    PairCopy(Crowd crowd, boolean copiesRestitution) {
        this.crowd = crowd;
        this.copiesRestitution = copiesRestitution;
        pair.add(0, 0, 1, 1);
        pair.add(0, 0, 1, 1);
    }

    /** Returns the sink for impacts of copies. */
    TurnSink begin(TurnSink sink) {
        idSink.sink = sink;
        return sink == TurnSink.NONE ? sink : idSink;
    }

    /** Copies a body of an impact. @param to 0 or 1 */
    void copy(int body, int to) {
        double[] state = crowd.state;
        idSink.id[to] = crowd.id[body];
        int at = 8 * body;
        pair.x[to] = state[at + Crowd.X];
        pair.y[to] = state[at + Crowd.Y];
        pair.vx[to] = state[at + Crowd.VX];
        pair.vy[to] = state[at + Crowd.VY];
        pair.radius[to] = state[at + Crowd.RADIUS];
        pair.mass[to] = crowd.mass[body];
        pair.inverseMass[to] = 1 / crowd.mass[body];
        if (copiesRestitution) {
            pair.restitution[to] = crowd.bodies.restitution[crowd.index[body]];
        }
    }

    /** Replaces the ids of the two copies by those of the bodies. */
    private static final class IdRestoringSink implements TurnSink {

        private TurnSink sink;
        private final int[] id = new int[2];

        @Override
        public void impact(double time, int a, int b, double ax, double ay, double bx, double by, double normalX,
                           double normalY, double impulse, double energy, double massA, double massB,
                           double vaxBefore, double vayBefore, double vaxAfter, double vayAfter,
                           double vbxBefore, double vbyBefore, double vbxAfter, double vbyAfter) {
            sink.impact(time, id[a], b < 0 ? b : id[b], ax, ay, bx, by, normalX, normalY, impulse, energy, massA,
                massB, vaxBefore, vayBefore, vaxAfter, vayAfter, vbxBefore, vbyBefore, vbxAfter, vbyAfter);
        }

        @Override
        public void knot(int bodyId, double time, double x, double y) {
            sink.knot(id[bodyId], time, x, y);
        }
    }
}
