package steward.physics.event;

import steward.physics.Advance;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.TurnSink;
import steward.physics.Wall;
import steward.physics.impulse.Collision;
import steward.physics.impulse.ContactResponse;
import steward.physics.impulse.ExactCollision;
import steward.physics.time.ExactPairs;
import steward.physics.time.ExactWalls;
import steward.physics.time.LowParts;
import steward.physics.time.Magnitudes;
import steward.physics.time.PairTime;

/**
 * The exact event loop: find the earliest impact, fly to it, apply it, search anew. Every search covers all pairs and
 * all walls, so a turn costs O(n^2) per impact: suited to the few bodies of a game. Allocates nothing in a turn once
 * its buffers have grown, except in the rare turns that reach the bound on impacts or need the exact arithmetic for
 * their numbers.
 *
 * <p>It always ends. A turn in which the impacts reach {@link ImpactLaw#impactLimit} is finished without impulses:
 * bodies that touch while they approach, and each body that comes into contact later, keep their place (so that no
 * overlap grows) and their velocity; the others fly on. The sink is called once, with the time and the ids.
 *
 * <p>A turn with numbers whose squares leave the range of doubles is computed in the exact arithmetic, whatever the
 * scene's; numbers that are out of range for that too are refused ({@link Advance#turn}).
 *
 * <p>Caveat: a body that starts a turn inside another, or behind a wall, reacts at once if it approaches (or, for
 * pairs, if the law lets separating pairs react).
 */
public final class EventAdvance implements Advance {

    private final PhysicsParts parts;
    private final ImpactLaw law;
    private final Scan[] scans;
    private final ImpactQueue queue;
    private final Flight flight;
    private final ContactResponse response;
    private final Standstill standstill;

    /** @param parts of the scene; what they lack is not searched for */
    public EventAdvance(PhysicsParts parts) {
        Wall[] walls = parts.walls().toArray(new Wall[0]);
        this.parts = parts;
        law = parts.law();
        if (parts.arithmetic() == Arithmetic.EXACT) {
            ExactPairs pairs = new ExactPairs(law);
            ExactWalls wallTimes = new ExactWalls(walls);
            RefiningQueue refining = new RefiningQueue(law, pairs, wallTimes, parts.contacts());
            LowParts lows = new LowParts();
            scans = Scan.of(parts, pairs, wallTimes);
            queue = refining;
            flight = new ExactFlight(refining, lows);
            response = ContactResponse.of(parts, ExactCollision.of(law, walls, pairs, wallTimes, lows), walls);
        } else {
            scans = Scan.of(parts, PairTime.of(law, parts.arithmetic()));
            queue = ImpactQueue.of(law);
            flight = new Flight.Plain();
            response = ContactResponse.of(parts, Collision.of(law, parts.arithmetic(), walls), walls);
        }
        standstill = new Standstill(parts);
    }

    @Override
    public void turn(Bodies bodies, TurnSink sink) {
        if (!Magnitudes.fitPlainArithmetic(bodies)) {
            if (parts.arithmetic() != Arithmetic.EXACT) {
                inExactArithmetic(parts).turn(bodies, sink);
                return;
            }
            Magnitudes.requireComputable(bodies, parts.walls());
        }
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

    /** An advance of the same scene for numbers out of the range of plain arithmetic, see {@link Magnitudes}. */
    public static EventAdvance inExactArithmetic(PhysicsParts parts) {
        return new EventAdvance(parts.withArithmetic(Arithmetic.EXACT));
    }

    /** Moves all bodies in free flight for a time. */
    static void fly(Bodies bodies, double time) {
        double[] x = bodies.x;
        double[] y = bodies.y;
        double[] vx = bodies.vx;
        double[] vy = bodies.vy;
        for (int i = 0; i < bodies.size(); i++) {
            x[i] += vx[i] * time;
            y[i] += vy[i] * time;
        }
    }
}
