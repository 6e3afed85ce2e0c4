package steward.physics.queue;

import static steward.physics.queue.Crowd.CHANGES;
import static steward.physics.queue.Crowd.EVENT;
import static steward.physics.queue.Crowd.PARTNER;
import static steward.physics.queue.Crowd.PARTNER_CHANGES;
import static steward.physics.queue.Crowd.VX;
import static steward.physics.queue.Crowd.VY;
import static steward.physics.queue.Crowd.X;
import static steward.physics.queue.Crowd.Y;

import java.util.Arrays;
import steward.physics.Bodies;
import steward.physics.TurnSink;
import steward.physics.event.Standstill;

/** {@link Standstill} for {@link QueueAdvance}: the next contacts come from the event queue. */
final class QueueStandstill {

    private final Crowd crowd;
    private final EventBuckets events;
    private final QueueSearch search;
    private final boolean[] stopped;

    QueueStandstill(Crowd crowd, EventBuckets events, QueueSearch search) {
        this.crowd = crowd;
        this.events = events;
        this.search = search;
        stopped = new boolean[crowd.size];
    }

    /**
     * Plays the rest of the turn; velocities are restored afterwards.
     *
     * @param start time of the last impact
     */
    void finish(Bodies bodies, double start, TurnSink sink) {
        double[] before = Arrays.copyOf(crowd.state, 8 * crowd.size);
        int[] link = crowd.link;
        for (int body = events.first(); body >= 0; body = events.first()) {
            double now = events.time(body);
            int partner = link[8 * body + PARTNER];
            if (link[8 * body + EVENT] != 0) {
                search.cross(body, now);
            } else if (partner >= 0 && link[8 * partner + CHANGES] != link[8 * body + PARTNER_CHANGES]) {
                search.predict(body, now);
            } else {
                crowd.setNow(body);
                boolean isFirst = partner < 0 || crowd.index[body] < crowd.index[partner];
                stop(isFirst ? body : partner, bodies, now, sink);
                if (partner >= 0) {
                    stop(isFirst ? partner : body, bodies, now, sink);
                    search.predict(partner, now);
                }
                search.predict(body, now);
            }
        }
        crowd.nowLow = 0;
        crowd.store(bodies, 1);
        int[] ids = new int[crowd.size];
        int count = 0;
        for (int body = 0; body < crowd.size; body++) {
            bodies.vx[crowd.index[body]] = before[8 * body + VX];
            bodies.vy[crowd.index[body]] = before[8 * body + VY];
            if (stopped[body]) {
                ids[count++] = bodies.id(crowd.index[body]);
            }
        }
        Arrays.sort(ids, 0, count);
        sink.impactLimit(start, Arrays.copyOf(ids, count));
    }

    private void stop(int body, Bodies bodies, double now, TurnSink sink) {
        if (!stopped[body]) {
            stopped[body] = true;
            crowd.flyTo(body, now);
            crowd.state[8 * body + VX] = 0;
            crowd.state[8 * body + VY] = 0;
            crowd.link[8 * body + CHANGES]++;
            sink.knot(bodies.id(crowd.index[body]), now, crowd.state[8 * body + X], crowd.state[8 * body + Y]);
        }
    }
}
