package steward.physics.event;

import java.util.Arrays;
import java.util.stream.IntStream;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.TurnSink;
import steward.physics.time.PairTime;

/**
 * Remainder of a turn whose impacts have reached their bound, played without impulses. The two bodies of a new contact,
 * or the body at a wall, stop for the rest of the turn. Every step stops at least one more body, so it ends.
 */
final class Standstill {

    private final Scan[] scans;
    private final ImpactQueue queue = new ImpactQueue(false, 0);
    private boolean[] stopped;

    Standstill(PhysicsParts parts) {
        scans = Scan.of(parts, PairTime.of(ImpactLaw.PHYSICS, Arithmetic.DOUBLE));
    }

    /** Plays the rest of the turn from {@code now}; velocities are restored afterwards. */
    void finish(Bodies bodies, double now, TurnSink sink) {
        int size = bodies.size();
        double[] vx = Arrays.copyOf(bodies.vx, size);
        double[] vy = Arrays.copyOf(bodies.vy, size);
        stopped = new boolean[size];
        Scan[] stopping = Arrays.stream(scans).map(scan -> scan.whileStopping(bodies, 1 - now)).toArray(Scan[]::new);
        double time = now;
        for (;;) {
            queue.clear();
            for (Scan scan : stopping) {
                scan.find(bodies, time, queue);
            }
            if (queue.nextBatch() == 0) {
                break;
            }
            EventAdvance.fly(bodies, queue.time(0) - time);
            time = queue.time(0);
            stop(bodies, queue.a(0), time, sink);
            if (queue.b(0) >= 0) {
                stop(bodies, queue.b(0), time, sink);
            }
        }
        EventAdvance.fly(bodies, 1 - time);
        System.arraycopy(vx, 0, bodies.vx, 0, size);
        System.arraycopy(vy, 0, bodies.vy, 0, size);
        sink.impactLimit(now, IntStream.range(0, size).filter(i -> stopped[i]).map(bodies::id).toArray());
    }

    private void stop(Bodies bodies, int body, double time, TurnSink sink) {
        if (!stopped[body]) {
            stopped[body] = true;
            bodies.vx[body] = 0;
            bodies.vy[body] = 0;
            sink.knot(bodies.id(body), time, bodies.x[body], bodies.y[body]);
        }
    }
}
