package steward.physics.event;

import steward.physics.Bodies;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.TurnSink;
import steward.physics.Wall;
import steward.physics.event.flight.FreeFlights;
import steward.physics.impulse.Accelerations;
import steward.physics.impulse.Collision;
import steward.physics.impulse.ContactResponse;
import steward.physics.impulse.Rest;
import steward.physics.time.LowParts;
import steward.physics.time.SimultaneousImpacts;

/**
 * Event loop for laws in which impacts happen one at a time. It takes the earliest impact, moves its two bodies there,
 * lets them react, and predicts their next impacts. Neighbours are found by all pairs or by cells ({@link
 * FreeFlights}); both give the same impacts in the same order, bit for bit.
 */
final class EventLoop {

    private final ImpactLaw law;
    private final FreeFlights flights;
    private final ContactResponse response;
    /** {@code null} where nothing rests. */
    private final Rest rest;
    /** {@code null} where no force acts. */
    private final Accelerations accelerations;
    private final Standstill standstill;
    private Bodies bodies;
    private TurnSink sink;
    /** The sink for impacts of bodies as they are shown. */
    private TurnSink impactSink;
    /** The number of bodies that {@link #accelerations} and {@link #rest} know, and the next id when they began. */
    private int known;
    private int knownIds;
    /** Number of impacts that the turn may still have. */
    private int left;

    /** @param lows in which the flights tell what rounding took */
    EventLoop(PhysicsParts parts, FreeFlights flights, LowParts lows) {
        Wall[] walls = parts.walls().toArray(new Wall[0]);
        this.flights = flights;
        law = parts.law();
        accelerations = Accelerations.of(parts);
        rest = Rest.of(parts, walls, accelerations);
        response = ContactResponse.of(parts, Collision.of(law, parts.arithmetic(), walls, lows, accelerations), walls);
        standstill = new Standstill(parts);
    }

    void turn(Bodies ofTurn, TurnSink of) {
        bodies = ofTurn;
        sink = of;
        impactSink = flights.begin(bodies, sink);
        left = law.impactLimit(bodies.size());
        beginLaws();
        double last = 0;
        double lastLow = 0;
        flights.nowLow = 0;
        flights.startAll(0);
        for (int body = flights.next(); body >= 0; body = flights.next()) {
            if (left <= 0) {
                flights.nowLow = lastLow;
                flights.endAll(last);
                standstill.finish(bodies, last, sink);
                response.releaseSeparatedPairs(bodies);
                return;
            }
            left--;
            SimultaneousImpacts together = flights.simultaneous(body);
            if (together == null) {
                last = flights.nextTime;
                lastLow = flights.nowLow;
                react(body, flights.nextPartner, last);
            } else {
                last = together.time();
                lastLow = together.timeLow();
                flights.nowLow = lastLow;
                reactInOrder(together, last);
            }
            if (rest != null && rest.isSqueezed()) {
                left = 0;
            }
        }
        flights.nowLow = 0;
        flights.endAll(1);
        response.releaseSeparatedPairs(bodies);
    }

    private void beginLaws() {
        known = bodies.size();
        knownIds = bodies.nextId();
        if (accelerations != null) {
            accelerations.begin(bodies);
        }
        if (rest != null) {
            rest.begin(bodies);
        }
    }

    private void react(int body, int partner, double now) {
        flights.flyToImpact(body, partner, now);
        if (leavesOthers(body, partner, now)) {
            flights.predictAfter(body, partner, now);
        }
    }

    /**
     * Impacts of one instant, decided from the states before the first of them, each on the velocities that those
     * before have left; where these separate a pair, it has no impact.
     */
    private void reactInOrder(SimultaneousImpacts together, double now) {
        int done = 0;
        for (; done < together.size() && (done == 0 || left > 0); done++) {
            int body = together.a(done);
            int partner = together.b(done);
            flights.flyToImpact(body, partner, now);
            if (done > 0) {
                flights.show(body, partner);
                if (!together.areApproaching(flights.shown(), flights.a(), flights.b())) {
                    continue;
                }
                left--;
            }
            if (!leavesOthers(body, partner, now)) {
                return;
            }
        }
        flights.predictAfter(together, done, now);
    }

    /** Lets a heap rest, or the two of an impact react. @return false if the flights of all bodies began anew */
    private boolean leavesOthers(int body, int partner, double now) {
        flights.show(body, partner);
        int a = flights.a();
        int b = flights.b();
        if (!(rest != null && rest.mayRest(bodies, a, b, now) && settles(a, b, now)) && respond(a, b, now)) {
            flights.take();
            return true;
        }
        if (bodies.size() != known || bodies.nextId() != knownIds) {
            beginLaws();
        }
        flights.startAll(now);
        return false;
    }

    /** Lets the heap of an impact rest. @return false if it is an ordinary impact */
    private boolean settles(int a, int b, double now) {
        double near = rest.near(a, b);
        if (near < 1 && rest.isPlain(bodies, a, b) && !flights.mayTouchOthers(near, now)) {
            return false;
        }
        flights.showAll(now);
        int impacts = rest.settle(bodies, a, b, now, sink);
        if (impacts == 0) {
            flights.hideAll();
            return false;
        }
        left -= impacts - 1;
        return true;
    }

    /**
     * Lets the two of an impact react; all bodies are shown if a reaction of the scene may look at them. Where they
     * need not be, nothing but the two can be altered.
     *
     * @return false if others were altered
     */
    private boolean respond(int a, int b, double now) {
        if (!response.needsAll(bodies, a, b)) {
            return response.react(flights.shown(), a, b, now, impactSink);
        }
        flights.showAll(now);
        if (!response.reactAlone(bodies, a, b, now, sink)) {
            return false;
        }
        flights.hideAll();
        return true;
    }
}
