package steward.physics.queue;

import static steward.physics.queue.Crowd.CHANGES;
import static steward.physics.queue.Crowd.EVENT;
import static steward.physics.queue.Crowd.PARTNER;
import static steward.physics.queue.Crowd.PARTNER_CHANGES;

import steward.physics.Advance;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.TurnSink;
import steward.physics.Wall;
import steward.physics.event.EventAdvance;
import steward.physics.event.Standstill;
import steward.physics.impulse.Collision;
import steward.physics.impulse.ExactCollision;
import steward.physics.impulse.Touch;
import steward.physics.time.ExactPairs;
import steward.physics.time.ExactWalls;
import steward.physics.time.LowParts;
import steward.physics.time.Magnitudes;

/**
 * The exact event loop for crowds: the same law and the same impacts as {@link EventAdvance}, at a cost per impact that
 * hardly depends on how many bodies there are. Bodies stand in cells and look for impacts only among their neighbours;
 * each has one event in a queue; and each has a clock of its own, so that only those fly that have an impact (after
 * B. Lubachevsky, "How to Simulate Billiards and Similar Systems", 1991, with a queue after G. Paul, 2007).
 *
 * <p>An event is its body's next impact or its way into the next cell. A body that is hit looks around anew; whoever
 * had foreseen an impact with it finds, when the time has come, that its partner's flight has changed since, and looks
 * around then.
 *
 * <p>The turn is begun anew from the bodies each time, so that its result depends on nothing but them. Ties go to the
 * lowest pair of ids. The bound on impacts is kept as in {@link Standstill}. Allocates nothing in a turn once its
 * arrays have grown (but for the rare ending by the impact limit).
 *
 * <p>A turn with numbers so large or small that squares leave the range of doubles is left to {@code EventAdvance} in
 * the exact arithmetic, which scales them.
 *
 * <p>Caveats: the same impacts as {@code EventAdvance} means but for rounding: that one moves every body at every
 * impact, this one moves it once, and where a crowd is chaotic the last digits grow into differences after some dozens
 * of impacts per body. Laws in which impacts react in batches are not for this class, see {@link #refusal}.
 */
public final class QueueAdvance implements Advance {

    private final PhysicsParts parts;
    private final ImpactLaw law;
    private final boolean descending;
    private final Crowd crowd;
    private final EventBuckets events;
    private final QueuePairs pairs;
    private final QueueSearch search;
    private final QueueTouch touch;
    private final Touch flown;

    /** @throws IllegalArgumentException if {@link #refusal} says that this law is not for it */
    public QueueAdvance(PhysicsParts parts) {
        String refusal = refusal(parts.law());
        if (refusal != null) {
            throw new IllegalArgumentException("queue: " + refusal);
        }
        Wall[] walls = parts.walls().toArray(new Wall[0]);
        this.parts = parts;
        law = parts.law();
        descending = law.scanOrder() == ImpactLaw.ScanOrder.DESCENDING;
        boolean exact = parts.arithmetic() == Arithmetic.EXACT;
        crowd = new Crowd(exact);
        events = new EventBuckets(new EventOrder(crowd));
        pairs = QueuePairs.of(crowd, parts);
        Collision collision;
        if (exact) {
            ExactPairs exactPairs = new ExactPairs(law);
            ExactWalls exactWalls = new ExactWalls(walls);
            LowParts rounded = new LowParts();
            search = new ExactQueueSearch(crowd, events, walls, pairs, exactPairs, exactWalls);
            collision = ExactCollision.of(law, walls, exactPairs, exactWalls, rounded);
            touch = QueueTouch.of(crowd, parts, collision, rounded, walls);
        } else {
            search = new QueueSearch(crowd, events, parts.arithmetic(), walls, pairs);
            collision = Collision.of(law, parts.arithmetic(), walls);
            touch = QueueTouch.of(crowd, parts, collision, null, walls);
        }
        flown = Touch.of(parts, collision, walls);
    }

    /** Why a law needs all pairs looked at after each impact, or {@code null} if it does not. */
    public static String refusal(ImpactLaw law) {
        return law.batchWindow() > 0 ? "impacts within batchWindow react together"
            : law.separatingPairsReact() ? "separatingPairs react" : null;
    }

    @Override
    public void turn(Bodies bodies, TurnSink sink) {
        if (!Magnitudes.areOrdinary(bodies)) {
            EventAdvance.scaling(parts).turn(bodies, sink);
            return;
        }
        if (bodies.size() > 0) {
            touch.begin(bodies, sink);
            crowd.nowLow = 0;
            if (pairs != null) {
                pairs.begin(bodies);
            }
            crowd.load(bodies, 0);
            predict(bodies.capacity(), 0);
            play(bodies, sink);
        }
        flown.flown(bodies);
    }

    /** What its arrays take after a turn, in bytes: below 200 for each body there is room for, from 150 on. */
    public long bytes() {
        return crowd.bytes() + events.bytes() + search.bytes();
    }

    /** Everybody looks around, at a time at which all have their places. */
    private void predict(int capacity, double now) {
        events.begin(crowd.size, capacity, now, crowd.meanGap());
        search.begin(capacity);
        for (int body = 0; body < crowd.size; body++) {
            search.predict(body, now);
        }
    }

    private void play(Bodies bodies, TurnSink sink) {
        int[] link = crowd.link;
        int left = law.impactLimit(bodies.size());
        double last = 0;
        for (int body = events.first(); body >= 0; body = events.first()) {
            double now = events.time(body);
            int at = 8 * body;
            if (link[at + EVENT] != 0) {
                search.cross(body, now);
            } else if (isStale(body)) {
                search.predict(body, now);
            } else if (left-- > 0) {
                react(bodies, body, link[at + PARTNER], now);
                last = now;
            } else {
                new QueueStandstill(crowd, events, search).finish(bodies, last, sink);
                return;
            }
        }
        crowd.nowLow = 0;
        crowd.store(bodies, 1);
    }

    private boolean isStale(int body) {
        int partner = crowd.link[8 * body + PARTNER];
        return partner >= 0 && crowd.link[8 * partner + CHANGES] != crowd.link[8 * body + PARTNER_CHANGES];
    }

    private void react(Bodies bodies, int body, int partner, double now) {
        crowd.setNow(body);
        double nowLow = crowd.nowLow;
        if (partner < 0) {
            crowd.fly(body, now);
            if (touch.happens(body, partner, now)) {
                changed(body);
                search.predict(body, now);
                return;
            }
        } else {
            crowd.meet(body, partner, now);
            boolean isFirst = crowd.index[body] < crowd.index[partner] != descending;
            if (touch.happens(isFirst ? body : partner, isFirst ? partner : body, now)) {
                changed(body);
                changed(partner);
                search.predict(body, now);
                search.predict(partner, now);
                return;
            }
        }
        crowd.nowLow = nowLow;
        crowd.load(bodies, now);
        predict(bodies.capacity(), now);
    }

    private void changed(int body) {
        crowd.link[8 * body + CHANGES]++;
    }
}
