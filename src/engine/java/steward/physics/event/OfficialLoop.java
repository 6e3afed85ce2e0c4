package steward.physics.event;

import java.util.Arrays;
import steward.physics.Advance;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;
import steward.physics.OfficialExpressions;
import steward.physics.PhysicsParts;
import steward.physics.TurnSink;
import steward.physics.time.Magnitudes;

/**
 * Common loop of the published official referees, filled in by each game: look for impacts, take the next ones, fly
 * there, let them react, repeat. A game adds its referee's own expressions, so that its turns have the same bits, and
 * names it as its {@link OfficialExpressions}, for the rung {@code event/official} only. Other rungs compute the same
 * game under the scene's {@link ImpactLaw}.
 *
 * <p>Times are in the game's own measure: some referees count from the start of the turn, some from now. Offers carry
 * ids, not indices, because a reaction may remove or add bodies while other impacts of its batch are still to come.
 *
 * <p>It ends as {@link EventAdvance} does: at the bound on impacts of the scene's law, with {@link Standstill}. A turn
 * with numbers whose squares leave the range of doubles is computed by the general loop in the exact arithmetic.
 * Allocates nothing in a turn once its buffers have grown, except in such rare turns.
 */
public abstract class OfficialLoop implements Advance {

    private final PhysicsParts parts;
    private final boolean keepsAll;
    private final Standstill standstill;
    private double[] times = new double[16];
    private int[] kinds = new int[16];
    private int[] firsts = new int[16];
    private int[] seconds = new int[16];
    private int size;

    /**
     * @param parts   of the scene; their law says what the bound on impacts is, and decides in turns that the game's
     *                expressions cannot compute
     * @param batches whether impacts can happen together: all offers are kept, in the order of time, ties in the order
     *                of the scan. Otherwise only the earliest is kept, of ties the first
     */
    protected OfficialLoop(PhysicsParts parts, boolean batches) {
        this.parts = parts;
        keepsAll = batches;
        standstill = new Standstill(parts);
    }

    /** Looks for impacts from {@code now} on and makes an {@link #offer} of each, in the order of the scan. */
    protected abstract void look(Bodies bodies, double now);

    /** True if the earliest offer is within the turn. */
    protected abstract boolean isInTurn(double now, double time);

    /** True if an offer happens together with the earliest. Asked only where there are batches. */
    protected boolean isTogether(double earliest, double time) {
        return false;
    }

    /**
     * Moves all bodies to the earliest offer.
     *
     * @param time of the offer
     * @return the time within the turn
     */
    protected abstract double fly(Bodies bodies, double now, double time);

    /** Moves all bodies to the end of the turn, in which nothing happens any more. */
    protected void flyToEnd(Bodies bodies, double now) {
        move(bodies, 1 - now);
    }

    /**
     * Lets an impact happen on the bodies as they now stand, and tells the sink about it.
     *
     * @param now  the time within the turn
     * @param time of the offer, at or after that of the earliest of its batch
     * @param kind as it was offered
     * @param a    an id; its body may have been removed by an impact of the same batch
     * @param b    an id, or as it was offered
     */
    protected abstract void react(Bodies bodies, double now, double time, int kind, int a, int b, TurnSink sink);

    /** True if the turn is over without another look. */
    protected boolean isOver(double now) {
        return false;
    }

    /**
     * Offers an impact.
     *
     * @param time in the game's own measure
     * @param kind the game's own kind of impact
     * @param a    id of a body
     * @param b    id of another, {@code ~wall}, or another number of the game
     */
    protected final void offer(double time, int kind, int a, int b) {
        if (!keepsAll) {
            if (size == 0 || time < times[0]) {
                size = 1;
                set(0, time, kind, a, b);
            }
            return;
        }
        if (size == times.length) {
            times = Arrays.copyOf(times, 2 * size);
            kinds = Arrays.copyOf(kinds, 2 * size);
            firsts = Arrays.copyOf(firsts, 2 * size);
            seconds = Arrays.copyOf(seconds, 2 * size);
        }
        int k = size++;
        while (k > 0 && times[k - 1] > time) {
            set(k, times[k - 1], kinds[k - 1], firsts[k - 1], seconds[k - 1]);
            k--;
        }
        set(k, time, kind, a, b);
    }

    private void set(int k, double time, int kind, int a, int b) {
        times[k] = time;
        kinds[k] = kind;
        firsts[k] = a;
        seconds[k] = b;
    }

    @Override
    public final void turn(Bodies bodies, TurnSink sink) {
        if (!Magnitudes.fitPlainArithmetic(bodies)) {
            EventAdvance.inExactArithmetic(parts).turn(bodies, sink);
            return;
        }
        int left = parts.law().impactLimit(bodies.size());
        double now = 0;
        while (!isOver(now)) {
            size = 0;
            look(bodies, now);
            if (size == 0 || !isInTurn(now, times[0])) {
                flyToEnd(bodies, now);
                return;
            }
            if (left <= 0) {
                standstill.finish(bodies, now, sink);
                return;
            }
            double earliest = times[0];
            now = fly(bodies, now, earliest);
            for (int k = 0; k < size && (k == 0 || isTogether(earliest, times[k])); k++) {
                react(bodies, now, times[k], kinds[k], firsts[k], seconds[k], sink);
                left--;
            }
        }
    }

    /** Moves all bodies in free flight for a time: x += vx * time. */
    protected static void move(Bodies bodies, double time) {
        EventAdvance.fly(bodies, time);
    }
}
