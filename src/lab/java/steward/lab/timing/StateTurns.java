package steward.lab.timing;

import java.util.List;
import steward.physics.Advance;
import steward.physics.Bodies;
import steward.physics.TurnSink;

/**
 * Timed flights of one turn from given states, in batches. Each batch plays copies that were made before it, so that
 * neither the copying nor the clock is included.
 */
final class StateTurns implements TimedWork {

    private static final int BATCH = 512;

    private final List<Bodies> states;
    private final Advance advance;
    private final Bodies[] copies;
    private int from;
    private int count;

    StateTurns(List<Bodies> states, Advance advance) {
        this.states = states;
        this.advance = advance;
        copies = new Bodies[Math.min(BATCH, states.size())];
    }

    @Override
    public void prepare() {
        from = from + count >= states.size() ? 0 : from + count;
        count = Math.min(copies.length, states.size() - from);
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
    public long run() {
        for (int k = 0; k < count; k++) {
            advance.turn(copies[k], TurnSink.NONE);
        }
        return count;
    }

    @Override
    public int cycle() {
        return (states.size() + copies.length - 1) / copies.length;
    }
}
