package steward.physics.event;

import steward.physics.Advance;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.TurnSink;
import steward.physics.event.cells.CellFlights;
import steward.physics.time.LowParts;
import steward.physics.time.Magnitudes;

/**
 * Exact event loop for many bodies: the impacts of {@link EventAdvance}, bit for bit, at a cost per impact that hardly
 * depends on their number. Bodies are kept in cells and impacts are predicted only among neighbours; each body has one
 * event in a queue; and each has a local clock, so that only bodies that have an impact are moved (after B.
 * Lubachevsky, "How to Simulate Billiards and Similar Systems", 1991, with a queue after G. Paul, 2007).
 *
 * <p>Every turn starts from the bodies alone, so that its result depends on nothing else. Allocates nothing in a turn
 * once its arrays have grown, to at most 240 bytes per body of the capacity, from 100 on, except in the rare turns that
 * reach the bound on impacts or are left to {@code EventAdvance}: those with numbers whose squares leave the range of
 * doubles. Laws in which impacts react in batches are refused, see {@link #refusal}.
 */
public final class QueueAdvance implements Advance {

    private final PhysicsParts parts;
    private final EventLoop loop;

    /** @throws IllegalArgumentException if {@link #refusal} refuses the law */
    public QueueAdvance(PhysicsParts parts) {
        this(parts, CellFlights.LEAST_READ_AHEAD);
    }

    /** @param readingFrom the number of bodies from which on memory is read ahead */
    QueueAdvance(PhysicsParts parts, int readingFrom) {
        String refusal = refusal(parts.law());
        if (refusal != null) {
            throw new IllegalArgumentException("queue: " + refusal);
        }
        LowParts lows = new LowParts();
        this.parts = parts;
        loop = new EventLoop(parts, new CellFlights(parts, lows, readingFrom), lows);
    }

    /** Returns why a law needs a scan of all pairs after each impact, or {@code null} if it does not. */
    public static String refusal(ImpactLaw law) {
        return law.batchWindow() > 0 ? "impacts within batchWindow react together"
            : law.separatingPairsReact() ? "separatingPairs react" : null;
    }

    @Override
    public void turn(Bodies bodies, TurnSink sink) {
        if (Magnitudes.fitPlainArithmetic(bodies)) {
            loop.turn(bodies, sink);
        } else {
            EventAdvance.inExactArithmetic(parts).turn(bodies, sink);
        }
    }
}
