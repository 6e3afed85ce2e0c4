package steward.physics.event;

import steward.physics.Bodies;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.TurnSink;
import steward.physics.Wall;
import steward.physics.impulse.Accelerations;
import steward.physics.impulse.Collision;
import steward.physics.impulse.ContactResponse;
import steward.physics.impulse.Rest;
import steward.physics.time.ExactPairs;
import steward.physics.time.ExactWalls;
import steward.physics.time.LowParts;
import steward.physics.time.SimultaneousImpacts;

/**
 * The event loop for laws in which one impact happens at a time. Each body has a local clock and is moved only at its
 * own impacts ({@link Flights}), as in {@code QueueAdvance}; so the two have the same impacts in the same order, bit
 * for bit. After an impact only the pairs of its two bodies are searched anew.
 */
final class FlightLoop {

    private final ImpactLaw law;
    private final boolean descending;
    private final Flights flights;
    private final FlightSearch search;
    private final ContactResponse response;
    private final Rest rest;
    /** {@code null} where no force acts. */
    private final Accelerations accelerations;
    private final Standstill standstill;
    /** Impacts that the last reaction recorded beyond the first: one for each contact of a heap at rest. */
    private int more;
    /** Starts of flights while all bodies are where they are now, for a reaction of the scene. */
    private double[] startX = new double[0];
    private double[] startY = new double[0];

    FlightLoop(PhysicsParts parts) {
        Wall[] walls = parts.walls().toArray(new Wall[0]);
        law = parts.law();
        descending = law.scanOrder() == ImpactLaw.ScanOrder.DESCENDING;
        accelerations = Accelerations.of(parts);
        if (parts.arithmetic().isExact()) {
            ExactPairs pairs = new ExactPairs(law);
            ExactWalls wallTimes = new ExactWalls(walls);
            LowParts lows = new LowParts();
            Flights.Precise precise = new Flights.Precise(lows);
            flights = precise;
            search = new PreciseFlightSearch(parts, precise, walls, pairs, wallTimes);
            response = ContactResponse.of(parts, Collision.ofExact(law, walls, pairs, wallTimes, lows, accelerations),
                walls);
        } else {
            flights = new Flights();
            search = new FlightSearch(parts, flights, walls);
            response = ContactResponse.of(parts, Collision.of(law, parts.arithmetic(), walls, accelerations),
                walls);
        }
        rest = Rest.of(parts, walls, accelerations);
        standstill = new Standstill(parts);
    }

    void turn(Bodies bodies, TurnSink sink) {
        int left = law.impactLimit(bodies.size());
        double last = 0;
        double lastLow = 0;
        flights.setNowLow(0);
        flights.startAll(bodies, 0);
        if (accelerations != null) {
            accelerations.begin(bodies);
        }
        if (rest != null) {
            rest.begin(bodies);
        }
        search.searchAll(bodies, 0);
        for (int row = search.earliest(bodies.size()); row >= 0; row = search.earliest(bodies.size())) {
            if (left-- <= 0) {
                flights.setNowLow(lastLow);
                storeAll(bodies, last);
                standstill.finish(bodies, last, sink);
                response.releaseSeparatedPairs(bodies);
                return;
            }
            SimultaneousImpacts together = search.simultaneous(bodies, search.time[row]);
            if (together != null) {
                flights.setNowLow(together.timeLow());
            }
            last = together == null ? search.time[row] : together.time();
            lastLow = flights.nowLow();
            if (together == null) {
                react(bodies, row, search.partner[row], last, sink);
                left -= more;
            } else {
                left = reactInOrder(bodies, together, last, left, sink);
            }
            if (rest != null && rest.isSqueezed()) {
                left = 0;
            }
        }
        flights.setNowLow(0);
        storeAll(bodies, 1);
        response.releaseSeparatedPairs(bodies);
    }

    private void storeAll(Bodies bodies, double now) {
        for (int i = 0; i < bodies.size(); i++) {
            flights.store(bodies, i, now);
        }
    }

    private void react(Bodies bodies, int row, int partner, double now, TurnSink sink) {
        fly(bodies, row, partner, now);
        if (reactAlone(bodies, row, partner, now, sink)) {
            search.searchAfter(bodies, row, partner, now);
        }
    }

    /**
     * Impacts of one instant, decided from the states before the first of them, each on the velocities that those
     * before have left; where these separate a pair, it has no impact.
     *
     * @return how many more impacts the turn may have
     */
    private int reactInOrder(Bodies bodies, SimultaneousImpacts together, double now, int most, TurnSink sink) {
        int left = most;
        int done = 0;
        for (; done < together.size() && (done == 0 || left > 0); done++) {
            int row = together.a(done);
            int partner = together.b(done);
            fly(bodies, row, partner, now);
            if (done > 0) {
                if (!search.areApproaching(bodies, row, partner)) {
                    continue;
                }
                left--;
            }
            if (!reactAlone(bodies, row, partner, now, sink)) {
                return left - more;
            }
        }
        for (int k = 0; k < done; k++) {
            search.searchAfter(bodies, together.a(k), together.b(k), now);
        }
        return left;
    }

    private void fly(Bodies bodies, int a, int b, double now) {
        if (b < 0) {
            flights.flyTo(bodies, a, now);
        } else {
            flights.flyToContact(bodies, a, b, now);
        }
    }

    /** Responds to an impact. @return false if all flights began anew and were searched */
    private boolean reactAlone(Bodies bodies, int row, int partner, double now, TurnSink sink) {
        boolean swapped = descending && partner >= 0;
        int a = swapped ? partner : row;
        int b = swapped ? row : partner;
        more = 0;
        if (rest != null && rest.isAbout(bodies, a, b) && rest.mayRest(bodies, a, b, now) && settle(bodies, a, b, now,
            sink)) {
            return false;
        }
        if (!respond(bodies, a, b, now, sink)) {
            if (rest != null) {
                rest.follow(bodies);
            }
            flights.startAll(bodies, now);
            search.searchAll(bodies, now);
            return false;
        }
        return true;
    }

    /**
     * Responds to a contact: all bodies are moved to the present time if a reaction of the scene may look at them, and
     * their flights go on afterwards.
     *
     * @return false if all flights begin anew at the present time
     */
    private boolean respond(Bodies bodies, int a, int b, double now, TurnSink sink) {
        if (!response.needsAll(bodies, a, b)) {
            return response.react(bodies, a, b, now, sink);
        }
        moveAll(bodies, a, b, now);
        if (!response.reactAlone(bodies, a, b, now, sink)) {
            return false;
        }
        moveBack(bodies, a, b);
        return true;
    }

    /** Lets a heap rest: then all flights begin anew. @return false if it is an ordinary impact */
    private boolean settle(Bodies bodies, int a, int b, double now, TurnSink sink) {
        moveAll(bodies, a, b, now);
        int impacts = rest.settle(bodies, a, b, now, sink);
        if (impacts == 0) {
            moveBack(bodies, a, b);
            return false;
        }
        more = impacts - 1;
        flights.startAll(bodies, now);
        search.searchAll(bodies, now);
        return true;
    }

    /** Moves all bodies but these two to the present time. */
    private void moveAll(Bodies bodies, int a, int b, double now) {
        if (startX.length < bodies.size()) {
            startX = new double[bodies.capacity()];
            startY = new double[bodies.capacity()];
        }
        for (int i = 0; i < bodies.size(); i++) {
            startX[i] = bodies.x[i];
            startY[i] = bodies.y[i];
            if (i != a && i != b) {
                flights.store(bodies, i, now);
            }
        }
    }

    /** Moves them back to the starts of their flights. */
    private void moveBack(Bodies bodies, int a, int b) {
        for (int i = 0; i < bodies.size(); i++) {
            if (i != a && i != b) {
                bodies.x[i] = startX[i];
                bodies.y[i] = startY[i];
            }
        }
    }
}
