package steward.physics.event;

import steward.physics.Bodies;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.TurnSink;
import steward.physics.Wall;
import steward.physics.impulse.Collision;
import steward.physics.impulse.ContactResponse;
import steward.physics.time.ExactPairs;
import steward.physics.time.ExactWalls;
import steward.physics.time.LowParts;
import steward.physics.time.PairTime;

/**
 * Event loop for laws in which impacts react in batches, as in official games. It moves all bodies to the earliest
 * impact, and after each batch it searches all pairs anew.
 */
final class BatchLoop {

    private final ImpactLaw law;
    private final Scan[] scans;
    private final ImpactQueue queue;
    private final Flight flight;
    private final ContactResponse response;
    private final Standstill standstill;

    BatchLoop(PhysicsParts parts) {
        Wall[] walls = parts.walls().toArray(new Wall[0]);
        law = parts.law();
        LowParts lows = new LowParts();
        if (parts.arithmetic().isExact()) {
            ExactPairs pairs = new ExactPairs(law);
            ExactWalls wallTimes = new ExactWalls(walls);
            ExactImpactQueue exactQueue = new ExactImpactQueue(parts, pairs, wallTimes);
            scans = Scan.of(parts, pairs, wallTimes);
            queue = exactQueue;
            flight = new Flight(exactQueue, lows);
        } else {
            scans = Scan.of(parts, PairTime.of(law, parts.arithmetic()));
            queue = new ImpactQueue(law);
            flight = new Flight(null, lows);
        }
        response = ContactResponse.of(parts, Collision.of(law, parts.arithmetic(), walls, lows, null), walls);
        standstill = new Standstill(parts);
    }

    void turn(Bodies bodies, TurnSink sink) {
        int left = law.impactLimit(bodies.size());
        double now = flight.begin(bodies);
        for (;;) {
            queue.clear();
            for (Scan scan : scans) {
                scan.find(bodies, now, queue);
            }
            int together = queue.nextBatch();
            if (together == 0) {
                flight.toEnd(bodies, now);
                response.releaseSeparatedPairs(bodies);
                return;
            }
            if (left <= 0) {
                standstill.finish(bodies, now, sink);
                response.releaseSeparatedPairs(bodies);
                return;
            }
            now = flight.toImpact(bodies, now, queue);
            response.releaseSeparatedPairs(bodies);
            left -= together;
            boolean unaltered = true;
            for (int k = 0; k < together && unaltered; k++) {
                unaltered = response.react(bodies, queue.a(k), queue.b(k), queue.time(k), sink);
            }
        }
    }
}
