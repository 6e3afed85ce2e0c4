package steward.physics.event;

import steward.physics.Advance;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.TurnSink;
import steward.physics.event.pairs.PairFlights;
import steward.physics.time.LowParts;
import steward.physics.time.Magnitudes;

/**
 * Exact event loop for few bodies: find the earliest impact, fly to it, apply it, search anew. Every turn begins with a
 * search of all pairs and all walls, O(n^2), and each impact costs O(n), or O(n^2) if impacts react in batches: suited
 * to the few bodies of a game. Allocates nothing in a turn once its buffers have grown, except in the rare turns that
 * reach the bound on impacts or need the exact arithmetic for their numbers.
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
    private final BatchLoop batches;
    private final EventLoop loop;

    /** @param parts of the scene; what they lack is not searched for */
    public EventAdvance(PhysicsParts parts) {
        boolean together = parts.law().batchWindow() > 0 || parts.law().separatingPairsReact();
        this.parts = parts;
        batches = together ? new BatchLoop(parts) : null;
        LowParts lows = new LowParts();
        loop = together ? null : new EventLoop(parts, new PairFlights(parts, lows), lows);
    }

    @Override
    public void turn(Bodies bodies, TurnSink sink) {
        if (!Magnitudes.fitPlainArithmetic(bodies)) {
            if (!parts.arithmetic().isExact()) {
                inExactArithmetic(parts).turn(bodies, sink);
                return;
            }
            Magnitudes.requireComputable(bodies, parts.walls());
        }
        if (loop != null) {
            loop.turn(bodies, sink);
        } else {
            batches.turn(bodies, sink);
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
