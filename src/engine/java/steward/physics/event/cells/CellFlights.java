package steward.physics.event.cells;

import static steward.physics.event.cells.Crowd.EVENT;
import static steward.physics.event.cells.Crowd.IMPACT;
import static steward.physics.event.cells.Crowd.IMPACT_LOW;
import static steward.physics.event.cells.Crowd.PARTNER;
import static steward.physics.event.cells.Crowd.PARTNER_CHANGES;

import steward.physics.Bodies;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.TurnSink;
import steward.physics.event.flight.FreeFlights;
import steward.physics.event.flight.PairSelection;
import steward.physics.impulse.Rest;
import steward.physics.time.LowParts;
import steward.physics.time.SimultaneousImpacts;

/**
 * Free flights with neighbours by cells and an event queue. An event is the predicted next impact of a body or its cell
 * crossing. A prediction of a body becomes stale if its partner has had another impact. That is detected by the count
 * of flight changes when the event is due; then the body is predicted anew.
 */
public final class CellFlights extends FreeFlights {

    /** The least number of bodies for which reading ahead pays: smaller crowds fit into the caches. */
    public static final int LEAST_READ_AHEAD = 1 << 16;
    /** Room for rounding where gaps of a heap are looked for. */
    private static final double ROOM = 1.01;

    private final boolean descending;
    private final Crowd crowd;
    private final EventBuckets events;
    private final LookAhead lookAhead;
    private final CellSearch search;
    /** {@code null} where others than the two may have a part in an impact. */
    private final PairCopy copy;
    /** The two of an impact, in the order in which they react. */
    private int first;
    private int second;
    /** Bodies whose impacts are near one time. */
    private int[] near = new int[0];
    private int nearCount;

    /** @param readingFrom the number of bodies from which on memory is read ahead */
    public CellFlights(PhysicsParts parts, LowParts lows, int readingFrom) {
        super(parts, lows);
        ImpactLaw law = parts.law();
        descending = law.scanOrder() == ImpactLaw.ScanOrder.DESCENDING;
        boolean rests = law.bodiesRest();
        crowd = new Crowd(exact, rests ? Math.max(Cells.SLACK, 1 + 2 * ROOM / Rest.NEAR) : Cells.SLACK,
            PairSelection.of(parts));
        events = new EventBuckets(crowd);
        lookAhead = new LookAhead(crowd, events, readingFrom);
        search = new CellSearch(parts, crowd, events);
        copy = rests || parts.reaction() != null || parts.forces().act() ? null
            : new PairCopy(crowd, law.restitution() == ImpactLaw.Restitution.MINIMUM);
    }

    @Override
    public TurnSink begin(Bodies ofTurn, TurnSink sink) {
        super.begin(ofTurn, sink);
        if (copy == null) {
            return sink;
        }
        shown = copy.pair;
        return copy.begin(sink);
    }

    @Override
    public void startAll(double now) {
        crowd.load(bodies, now, nowLow);
        events.begin(crowd.size, bodies.capacity(), now, crowd.meanGap(), crowd.link, crowd.state);
        search.begin(bodies.capacity());
        for (int body = 0; body < crowd.size; body++) {
            search.predict(body, now);
        }
        lookAhead.begin();
    }

    @Override
    public int next() {
        int body = events.first();
        for (; body >= 0; body = events.first()) {
            lookAhead.read();
            if (!crossesOrIsStale(body)) {
                nextTime = events.time(body);
                nextPartner = crowd.link[8 * body + PARTNER];
                nowLow = exact ? crowd.low[4 * body + IMPACT_LOW] : 0;
                break;
            }
        }
        return body;
    }

    /** Handles an event that is no impact. @return whether it was none */
    private boolean crossesOrIsStale(int body) {
        int[] link = crowd.link;
        int at = 8 * body;
        if (link[at + EVENT] != 0) {
            search.cross(body, events.time(body));
            return true;
        }
        int partner = link[at + PARTNER];
        if (partner >= 0 && crowd.cells.changes(partner) != link[at + PARTNER_CHANGES]) {
            search.predict(body, events.time(body));
            return true;
        }
        return false;
    }

    @Override
    public SimultaneousImpacts simultaneous(int body) {
        if (!exact || removeIfAlone(body, nextTime)) {
            return null;
        }
        removeNear(nextTime);
        return search.collect(near, nearCount, nextTime);
    }

    /** Removes the events of a body and its partner if no other impact can be at their time. @return whether it did */
    private boolean removeIfAlone(int body, double now) {
        int partner = nextPartner;
        if (search.isDoubtful(body) || partner >= 0 && search.isDoubtful(partner) && isNear(partner, now)) {
            return false;
        }
        boolean mirrored = partner >= 0 && crowd.link[8 * partner + PARTNER] == body
            && crowd.link[8 * partner + EVENT] == 0 && isNear(partner, now);
        events.remove(body);                               // both are predicted anew after their impact
        if (mirrored) {
            events.remove(partner);
        }
        int next = events.first();
        boolean others = next >= 0 && events.time(next) - now <= SimultaneousImpacts.NEAR;
        if (others) {
            events.put(body, now);
            if (mirrored) {
                events.put(partner, crowd.state[8 * partner + IMPACT]);
            }
        }
        return !others;
    }

    private boolean isNear(int body, double now) {
        return crowd.state[8 * body + IMPACT] - now <= SimultaneousImpacts.NEAR;
    }

    /** Removes the impacts near a time from the queue, after all other events near it. */
    private void removeNear(double time) {
        if (near.length < crowd.size) {
            near = new int[bodies.capacity()];
        }
        nearCount = 0;
        for (int body = events.first(); body >= 0 && events.time(body) - time <= SimultaneousImpacts.NEAR;
             body = events.first()) {
            if (!crossesOrIsStale(body)) {
                events.remove(body);
                near[nearCount++] = body;
            }
        }
    }

    @Override
    public void predictAfter(int body, int partner, double now) {
        search.predict(body, now);
        if (partner >= 0) {
            search.predict(partner, now);
        }
    }

    @Override
    public void predictAfter(SimultaneousImpacts together, int done, double now) {
        for (int k = 0; k < nearCount; k++) {
            search.predict(near[k], now);
        }
        for (int k = 0; k < done; k++) {
            predictAfter(together.a(k), together.b(k), now);
        }
    }

    @Override
    public void show(int body, int partner) {
        boolean swapped = partner >= 0 && crowd.index[body] < crowd.index[partner] == descending;
        first = swapped ? partner : body;
        second = swapped ? body : partner;
        a = copy != null ? 0 : crowd.index(first);
        b = copy != null && second >= 0 ? 1 : crowd.index(second);
        showAt(first, a);
        if (second >= 0) {
            showAt(second, b);
        }
    }

    private void showAt(int body, int to) {
        if (copy != null) {
            copy.copy(body, to);
        } else {
            crowd.show(body);
        }
        if (exact) {
            lows.set(to, crowd.low[4 * body + Crowd.X_LOW], crowd.low[4 * body + Crowd.Y_LOW]);
        }
    }

    @Override
    public void take() {
        crowd.take(first, shown, a);
        if (second >= 0) {
            crowd.take(second, shown, b);
        }
    }

    @Override
    public void showAll(double now) {
        endAll(now);
    }

    @Override
    public void hideAll() {
        // the bodies of the turn are copies
    }

    @Override
    public boolean mayTouchOthers(double gapShare, double now) {
        return search.hasNear(first, second, ROOM * gapShare, now)
            || second >= 0 && search.hasNear(second, first, ROOM * gapShare, now);
    }

    @Override
    public void endAll(double now) {
        for (int body = 0; body < crowd.size; body++) {
            crowd.store(body, now, nowLow);
        }
    }

    @Override
    protected double since(int body) {
        return crowd.state[8 * body + Crowd.SINCE];
    }

    @Override
    protected double sinceLow(int body) {
        return crowd.low[4 * body + Crowd.SINCE_LOW];
    }

    @Override
    protected void fly(int body, double now) {
        crowd.fly(body, now, nowLow);
    }
}
