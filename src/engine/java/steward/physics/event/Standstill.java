package steward.physics.event;

import java.util.Arrays;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.TurnSink;
import steward.physics.time.PairTime;

/**
 * Plays the rest of a turn whose impacts have reached their bound, without impulses: the two bodies of a new contact,
 * or the body at a wall, stop for the rest of the turn. Every step stops at least one more body, so it ends.
 */
public final class Standstill {

    private final Scan[] scans;
    private final ImpactQueue queue = new ImpactQueue.OneAtATime();

    Standstill(PhysicsParts parts) {
        scans = Scan.of(parts, PairTime.of(ImpactLaw.PHYSICS, Arithmetic.DOUBLE));
    }

    /** Plays the rest of the turn from {@code now}; velocities are restored afterwards. */
    void finish(Bodies bodies, double now, TurnSink sink) {
        Stopped stopped = new Stopped(bodies);
        double time = now;
        for (;;) {
            queue.clear();
            for (Scan scan : scans) {
                scan.find(bodies, time, queue);
            }
            if (queue.nextBatch() == 0) {
                break;
            }
            EventAdvance.fly(bodies, queue.time(0) - time);
            time = queue.time(0);
            stop(bodies, queue.a(0), time, stopped, sink);
            if (queue.b(0) >= 0) {
                stop(bodies, queue.b(0), time, stopped, sink);
            }
        }
        EventAdvance.fly(bodies, 1 - time);
        stopped.end(bodies, now, sink);
    }

    private static void stop(Bodies bodies, int body, double time, Stopped stopped, TurnSink sink) {
        if (stopped.add(body)) {
            bodies.vx[body] = 0;
            bodies.vy[body] = 0;
            sink.knot(bodies.id(body), time, bodies.x[body], bodies.y[body]);
        }
    }

    /** The bodies that have stopped, and the velocities that all get back in the end. */
    public static final class Stopped {

        private final double[] vx;
        private final double[] vy;
        private final boolean[] stopped;
        private int count;

        /** @param bodies with the velocities that they have when the impacts have reached their bound */
        public Stopped(Bodies bodies) {
            vx = Arrays.copyOf(bodies.vx, bodies.size());
            vy = Arrays.copyOf(bodies.vy, bodies.size());
            stopped = new boolean[bodies.size()];
        }

        /** Counts a body. @return whether it is new */
        public boolean add(int body) {
            boolean isNew = !stopped[body];
            stopped[body] = true;
            count += isNew ? 1 : 0;
            return isNew;
        }

        /** At the end of the turn: restores the velocities and tells the sink who has stopped. */
        public void end(Bodies bodies, double since, TurnSink sink) {
            System.arraycopy(vx, 0, bodies.vx, 0, vx.length);
            System.arraycopy(vy, 0, bodies.vy, 0, vy.length);
            int[] ids = new int[count];
            for (int i = 0, k = 0; i < stopped.length; i++) {
                if (stopped[i]) {
                    ids[k++] = bodies.id(i);
                }
            }
            sink.impactLimit(since, ids);
        }
    }
}
