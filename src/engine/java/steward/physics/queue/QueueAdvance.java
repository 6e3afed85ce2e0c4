package steward.physics.queue;

import static steward.physics.queue.Crowd.EVENT;
import static steward.physics.queue.Crowd.PARTNER;
import static steward.physics.queue.Crowd.PARTNER_CHANGES;

import steward.physics.Advance;
import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.TurnSink;
import steward.physics.Wall;
import steward.physics.event.EventAdvance;
import steward.physics.event.Standstill;
import steward.physics.impulse.Accelerations;
import steward.physics.impulse.Collision;
import steward.physics.impulse.ContactResponse;
import steward.physics.impulse.Rest;
import steward.physics.time.ExactPairs;
import steward.physics.time.ExactWalls;
import steward.physics.time.LowParts;
import steward.physics.time.Magnitudes;
import steward.physics.time.SimultaneousImpacts;

/**
 * The exact event loop for many bodies: the same law and the same impacts as {@link EventAdvance}, at a cost per impact
 * that hardly depends on the number of bodies. Bodies are kept in cells and impacts are predicted only among
 * neighbours; each body has one event in a queue; and each has a local clock, so that only bodies that have an impact
 * are moved (after B. Lubachevsky, "How to Simulate Billiards and Similar Systems", 1991, with a queue after G. Paul,
 * 2007).
 *
 * <p>An event is the predicted next impact of a body or its cell crossing. After an impact the events of its bodies are
 * predicted anew. A prediction of another body with one of these becomes stale: this is detected by the count of flight
 * changes when the event is due, and then that body is predicted anew.
 *
 * <p>Every turn starts from the bodies alone, so that its result depends on nothing else. Ties go to the lowest pair of
 * ids. The bound on impacts is kept as in {@link Standstill}. Allocates nothing in a turn once its arrays have grown,
 * except in the rare turns that reach the bound on impacts or are left to {@code EventAdvance}.
 *
 * <p>A turn with numbers whose squares leave the range of doubles is left to {@code EventAdvance} in the exact
 * arithmetic, which scales them.
 *
 * <p>The impacts are those of {@code EventAdvance}, in the same order and bit for bit: both move a body only at its own
 * impacts. Only in turns that reach the bound on impacts the rest of the turn can differ in the last bits. Laws in
 * which impacts react in batches are refused, see {@link #refusal}.
 */
public final class QueueAdvance implements Advance {

    /** Room for rounding where gaps of a heap are looked for. */
    private static final double ROOM = 1.01;

    private final PhysicsParts parts;
    private final ImpactLaw law;
    private final boolean descending;
    private final Crowd crowd;
    private final EventBuckets events;
    private final LookAhead lookAhead;
    private final QueuePairs pairs;
    private final QueueSearch search;
    private final QueueContactResponse response;
    private final ContactResponse passing;
    private final Rest rest;
    /** {@code null} where no force acts. */
    private final Accelerations accelerations;
    /** Impacts that the last reaction recorded beyond the first: one for each contact of a heap at rest. */
    private int more;
    /** Bodies whose impacts are near one time. */
    private int[] simultaneous = new int[0];

    /** @throws IllegalArgumentException if {@link #refusal} refuses the law */
    public QueueAdvance(PhysicsParts parts) {
        this(parts, LookAhead.LEAST_BODIES);
    }

    /** @param readingFrom the number of bodies from which on memory is read ahead */
    QueueAdvance(PhysicsParts parts, int readingFrom) {
        String refusal = refusal(parts.law(), parts.contacts());
        if (refusal != null) {
            throw new IllegalArgumentException("queue: " + refusal);
        }
        Wall[] walls = parts.walls().toArray(new Wall[0]);
        this.parts = parts;
        law = parts.law();
        descending = law.scanOrder() == ImpactLaw.ScanOrder.DESCENDING;
        boolean exact = parts.arithmetic().isExact();
        accelerations = Accelerations.of(parts);
        rest = Rest.of(parts, walls, accelerations);
        crowd = new Crowd(exact, rest == null ? Cells.SLACK : Math.max(Cells.SLACK, 1 + 2 * ROOM / Rest.NEAR));
        events = new EventBuckets(new EventOrder(crowd));
        lookAhead = new LookAhead(crowd, events, readingFrom);
        pairs = QueuePairs.of(crowd, parts);
        Collision collision;
        if (exact) {
            ExactPairs exactPairs = new ExactPairs(law);
            ExactWalls exactWalls = new ExactWalls(walls);
            LowParts rounded = new LowParts();
            search = new ExactQueueSearch(crowd, events, walls, pairs, exactPairs, exactWalls);
            collision = Collision.ofExact(law, walls, exactPairs, exactWalls, rounded, accelerations);
            response = QueueContactResponse.of(crowd, parts, collision, rounded, walls);
        } else {
            search = new QueueSearch(crowd, events, parts.arithmetic(), walls, pairs);
            collision = Collision.of(law, parts.arithmetic(), walls, accelerations);
            response = QueueContactResponse.of(crowd, parts, collision, null, walls);
        }
        passing = ContactResponse.of(parts, collision, walls);
    }

    /** Returns why a law needs a scan of all pairs after each impact, or {@code null} if it does not. */
    public static String refusal(ImpactLaw law) {
        return law.batchWindow() > 0 ? "impacts within batchWindow react together"
            : law.separatingPairsReact() ? "separatingPairs react" : null;
    }

    /** Returns why a law with these contacts needs a scan of all pairs, or {@code null}. */
    public static String refusal(ImpactLaw law, Contacts contacts) {
        return refusal(law) != null ? refusal(law)
            : contacts.hasReaches() ? "some contacts have a distance of their own" : null;
    }

    @Override
    public void turn(Bodies bodies, TurnSink sink) {
        if (!Magnitudes.fitPlainArithmetic(bodies)) {
            EventAdvance.inExactArithmetic(parts).turn(bodies, sink);
            return;
        }
        if (bodies.size() > 0) {
            response.begin(bodies, sink);
            if (accelerations != null) {
                accelerations.begin(bodies);
            }
            if (rest != null) {
                rest.begin(bodies);
            }
            crowd.nowLow = 0;
            if (pairs != null) {
                pairs.begin(bodies);
            }
            crowd.load(bodies, 0);
            predict(bodies.capacity(), 0);
            processEvents(bodies, sink);
        }
        passing.releaseSeparatedPairs(bodies);
    }

    /** The size of its arrays after a turn, in bytes: at most 220 per body of the capacity, from 100 on. */
    public long bytes() {
        return crowd.bytes() + events.bytes() + search.bytes() + lookAhead.bytes();
    }

    /** Predicts the events of all bodies, at a time to which all have been moved. */
    private void predict(int capacity, double now) {
        events.begin(crowd.size, capacity, now, crowd.meanGap(), crowd.link, crowd.state);
        search.begin(capacity);
        for (int body = 0; body < crowd.size; body++) {
            search.predict(body, now);
        }
        lookAhead.begin();
    }

    private void processEvents(Bodies bodies, TurnSink sink) {
        int[] link = crowd.link;
        int left = law.impactLimit(bodies.size());
        double last = 0;
        Standstill.Stopped stopped = null;
        for (int body = events.first(); body >= 0; body = events.first()) {
            lookAhead.read();
            double now = events.time(body);
            int at = 8 * body;
            if (link[at + EVENT] != 0) {
                search.cross(body, now);
            } else if (isStale(body)) {
                search.predict(body, now);
            } else if (stopped == null && left-- > 0) {
                if (search.mayBeSimultaneous(body, now)) {
                    left = reactInOrder(bodies, now, left, sink);
                } else {
                    react(bodies, body, link[at + PARTNER], now, sink);
                    left -= more;
                }
                last = now;
                if (rest != null && rest.isSqueezed()) {
                    left = 0;
                }
            } else {
                if (stopped == null) {
                    crowd.storeVelocities(bodies);
                    stopped = new Standstill.Stopped(bodies);
                }
                stop(bodies, body, link[at + PARTNER], now, stopped, sink);
            }
        }
        crowd.nowLow = 0;
        crowd.store(bodies, 1);
        if (stopped != null) {
            stopped.end(bodies, last, sink);
        }
    }

    /** Stops a body, and its partner unless that is a wall, where they meet: see {@link Standstill}. */
    private void stop(Bodies bodies, int body, int partner, double now, Standstill.Stopped stopped, TurnSink sink) {
        crowd.setNow(body);
        boolean isFirst = partner < 0 || crowd.index[body] < crowd.index[partner];
        stop(bodies, isFirst ? body : partner, now, stopped, sink);
        if (partner >= 0) {
            stop(bodies, isFirst ? partner : body, now, stopped, sink);
            search.predict(partner, now);
        }
        search.predict(body, now);
    }

    private void stop(Bodies bodies, int body, double now, Standstill.Stopped stopped, TurnSink sink) {
        if (stopped.add(crowd.index[body])) {
            crowd.stop(body, now);
            countChange(body);
            sink.knot(bodies.id(crowd.index[body]), now, crowd.x(body), crowd.y(body));
        }
    }

    private boolean isStale(int body) {
        int partner = crowd.link[8 * body + PARTNER];
        return partner >= 0 && crowd.cells.changes(partner) != crowd.link[8 * body + PARTNER_CHANGES];
    }

    private void react(Bodies bodies, int body, int partner, double now, TurnSink sink) {
        crowd.setNow(body);
        fly(body, partner, now);
        if (reactAlone(bodies, body, partner, now, sink)) {
            predict(body, partner, now);
        }
    }

    /**
     * Impacts of one instant, decided from the states before the first of them, as {@code FlightLoop} lets them react.
     *
     * @return how many more impacts the turn may have
     */
    private int reactInOrder(Bodies bodies, double earliest, int most, TurnSink sink) {
        int left = most;
        int count = removeNear(bodies.capacity(), earliest);
        SimultaneousImpacts together = search.collect(simultaneous, count, earliest);
        double now = together.time();
        int done = 0;
        for (; done < together.size() && (done == 0 || left > 0); done++) {
            int body = together.a(done);
            int partner = together.b(done);
            crowd.nowLow = together.timeLow();
            fly(body, partner, now);
            if (done > 0) {
                if (!search.areApproaching(body, partner)) {
                    continue;
                }
                left--;
            }
            if (!reactAlone(bodies, body, partner, now, sink)) {
                return left - more;
            }
        }
        for (int k = 0; k < count; k++) {
            search.predict(simultaneous[k], now);
        }
        for (int k = 0; k < done; k++) {
            predict(together.a(k), together.b(k), now);
        }
        return left;
    }

    /** Removes the impacts near a time from the queue, after all other events near it. @return how many */
    private int removeNear(int capacity, double time) {
        if (simultaneous.length < crowd.size) {
            simultaneous = new int[capacity];
        }
        int count = 0;
        for (int body = events.first(); body >= 0 && events.time(body) - time <= SimultaneousImpacts.NEAR;
             body = events.first()) {
            if (crowd.link[8 * body + EVENT] != 0) {
                search.cross(body, events.time(body));
            } else if (isStale(body)) {
                search.predict(body, events.time(body));
            } else {
                events.remove(body);
                simultaneous[count++] = body;
            }
        }
        return count;
    }

    private void fly(int body, int partner, double now) {
        countChange(body);
        if (partner < 0) {
            crowd.flyTo(body, now);
        } else {
            countChange(partner);
            crowd.flyToContact(body, partner, now);
        }
    }

    private void predict(int body, int partner, double now) {
        search.predict(body, now);
        if (partner >= 0) {
            search.predict(partner, now);
        }
    }

    /** Responds to an impact. @return false if the flights of all bodies began anew and were predicted */
    private boolean reactAlone(Bodies bodies, int body, int partner, double now, TurnSink sink) {
        double nowLow = crowd.nowLow;
        more = 0;
        boolean isFirst = partner < 0 || crowd.index[body] < crowd.index[partner] != descending;
        int a = isFirst ? body : partner;
        int b = isFirst ? partner : body;
        if (!(rest != null && rests(bodies, a, b, now, sink)) && response.react(a, b, now)) {
            return true;
        }
        crowd.nowLow = nowLow;
        crowd.load(bodies, now);
        predict(bodies.capacity(), now);
        if (rest != null) {
            rest.follow(bodies);
        }
        return false;
    }

    /** Lets the heap of an impact rest; then all flights begin anew. @return false if it is an ordinary impact */
    private boolean rests(Bodies bodies, int a, int b, double now, TurnSink sink) {
        int i = crowd.index[a];
        int j = b < 0 ? b : crowd.index[b];
        crowd.store(a, bodies, now);
        if (b >= 0) {
            crowd.store(b, bodies, now);
        }
        if (!rest.isAbout(bodies, i, j) || !rest.mayRest(bodies, i, j, now)) {
            return false;
        }
        double near = rest.near(i, j);
        if (near < 1 && rest.isPlain(bodies, i, j) && !search.hasNear(a, b, ROOM * near, now)
            && (b < 0 || !search.hasNear(b, a, ROOM * near, now))) {
            return false;
        }
        crowd.store(bodies, now);
        int impacts = rest.settle(bodies, i, j, now, sink);
        more = Math.max(0, impacts - 1);
        return impacts > 0;
    }

    private void countChange(int body) {
        crowd.cells.countChange(body);
    }
}
