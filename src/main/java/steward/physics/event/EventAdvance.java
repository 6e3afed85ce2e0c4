package steward.physics.event;

import steward.physics.Advance;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.TurnSink;
import steward.physics.Wall;
import steward.physics.impulse.Collision;
import steward.physics.impulse.ExactCollision;
import steward.physics.impulse.Touch;
import steward.physics.time.ExactPairs;
import steward.physics.time.ExactWalls;
import steward.physics.time.LowParts;
import steward.physics.time.Magnitudes;
import steward.physics.time.PairTime;

/**
 * The exact event loop: find the earliest impact, fly there, let it react, look anew. Every pair and every wall is
 * looked at each time, so a turn costs O(n^2) per impact: right for the few bodies of a game. Allocates nothing in a
 * turn once its buffers have grown (but for the rare ending by the impact limit).
 *
 * <p>It always ends. A turn in which the impacts reach {@link ImpactLaw#impactLimit} is finished without impulses: the
 * bodies that touch while they approach, and each that later runs into something, keep their places (so that no
 * overlap grows) and their velocities; the others fly on. The sink is told once, with the time and the ids.
 *
 * <p>Numbers so large or small that squares leave the range of doubles are computed in the exact arithmetic, whatever
 * the scene's; those that it cannot compute either are refused ({@link Advance#turn}).
 *
 * <p>Caveat: an impact is looked for between the present positions; a body that starts a turn inside another, or behind
 * a wall, reacts at once if it approaches (or if the law lets separating pairs react).
 */
public final class EventAdvance implements Advance {

    private final PhysicsParts parts;
    private final ImpactLaw law;
    private final Scan[] scans;
    private final ImpactQueue queue;
    private final Flight flight;
    private final Touch touch;
    private final Standstill standstill;

    /** @param parts of the scene; what they lack is not looked for */
    public EventAdvance(PhysicsParts parts) {
        Wall[] walls = parts.walls().toArray(new Wall[0]);
        this.parts = parts;
        law = parts.law();
        if (parts.arithmetic() == Arithmetic.EXACT) {
            ExactPairs pairs = new ExactPairs(law);
            ExactWalls wallTimes = new ExactWalls(walls);
            RefiningQueue refining = new RefiningQueue(law, pairs, wallTimes);
            LowParts lows = new LowParts();
            scans = Scan.of(parts, pairs, wallTimes);
            queue = refining;
            flight = new ExactFlight(refining, lows);
            touch = Touch.of(parts, ExactCollision.of(law, walls, pairs, wallTimes, lows), walls);
        } else {
            scans = Scan.of(parts, PairTime.of(law, parts.arithmetic()));
            queue = ImpactQueue.of(law);
            flight = new Flight.Plain();
            touch = Touch.of(parts, Collision.of(law, parts.arithmetic(), walls), walls);
        }
        standstill = new Standstill(parts);
    }

    @Override
    public void turn(Bodies bodies, TurnSink sink) {
        if (!Magnitudes.areOrdinary(bodies)) {
            if (parts.arithmetic() != Arithmetic.EXACT) {
                scaling(parts).turn(bodies, sink);
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
            int together = queue.next();
            if (together == 0) {
                flight.toEnd(bodies, now);
                touch.flown(bodies);
                return;
            }
            if (left <= 0) {
                standstill.finish(bodies, now, sink);
                touch.flown(bodies);
                return;
            }
            now = flight.toImpact(bodies, now, queue);
            touch.flown(bodies);
            left -= together;
            boolean unaltered = true;
            for (int k = 0; k < together && unaltered; k++) {
                unaltered = touch.happens(bodies, queue.a(k), queue.b(k), queue.time(k), sink);
            }
        }
    }

    /** An advance of the same scene for numbers that are not {@link Magnitudes ordinary}. */
    public static EventAdvance scaling(PhysicsParts parts) {
        return new EventAdvance(new PhysicsParts(parts.law(), Arithmetic.EXACT, parts.contacts(), parts.walls(),
            parts.reaction(), parts.infiniteMasses()));
    }

    /** Everybody flies straight for a while. */
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
