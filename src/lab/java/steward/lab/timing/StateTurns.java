package steward.lab.timing;

import java.util.List;
import steward.physics.Advance;
import steward.physics.Bodies;
import steward.physics.Motion;
import steward.physics.TurnSink;

/**
 * A turn from each of some states, in batches: each batch plays copies that were made before it, so that neither the
 * copying nor the clock is included.
 */
public final class StateTurns implements TimedTurns {

    private static final int BATCH = 512;

    private final List<Bodies> states;
    private final Advance advance;
    private final Motion motion;
    private final TurnSink sink;
    private final Runnable clear;
    private final Bodies[] copies;
    private int from;
    private int count;

    /** Flights alone. */
    public StateTurns(List<Bodies> states, Advance advance) {
        this(states, advance, null, TurnSink.NONE, () -> { });
    }

    /**
     * @param motion of the end of each turn; {@code null} for none
     * @param sink   takes what happens
     * @param clear  empties the sink, before each batch
     */
    public StateTurns(List<Bodies> states, Advance advance, Motion motion, TurnSink sink, Runnable clear) {
        this.states = states;
        this.advance = advance;
        this.motion = motion;
        this.sink = sink;
        this.clear = clear;
        copies = new Bodies[Math.min(BATCH, states.size())];
    }

    @Override
    public void prepare() {
        from = from + count >= states.size() ? 0 : from + count;
        count = Math.min(copies.length, states.size() - from);
        clear.run();
        for (int k = 0; k < count; k++) {
            Bodies state = states.get(from + k);
            if (copies[k] == null || copies[k].capacity() != state.capacity()) {
                copies[k] = state.copy();
            } else {
                copies[k].copyFrom(state);
            }
        }
    }

    @Override
    public void run() {
        for (int k = 0; k < count; k++) {
            advance.turn(copies[k], sink);
            if (motion != null) {
                motion.endTurn(copies[k]);
            }
        }
    }

    @Override
    public int turns() {
        return count;
    }

    @Override
    public int cycle() {
        return (states.size() + copies.length - 1) / copies.length;
    }
}
