package steward.lab.tradeoff;

import java.util.Arrays;
import java.util.List;
import steward.lab.oracle.Oracle;
import steward.lab.oracle.OracleBody;
import steward.lab.oracle.TurnTruth;
import steward.physics.Advance;
import steward.physics.Bodies;
import steward.physics.PhysicsParts;
import steward.physics.TurnSink;

/** Free run of a scene on every rung and in truth, turn after turn, to find after how many turns a rung diverges. */
final class TradeoffFreeRun {

    /** A body farther than this from its true position, in u, has diverged. */
    static final double OFF = 1;

    /**
     * After how many turns each rung has diverged; one more than the bound if it never does. From the first turn on in
     * which the oracle stops ({@link Oracle#rested}), truth is {@code exact}.
     *
     * @param bound how many turns at most; fewer if the true turn reaches the law's limit on impacts
     */
    static int[] turns(Bodies start, PhysicsParts parts, List<Advance> rungs, int bound) {
        List<OracleBody> truth = OracleBody.of(start);
        Oracle oracle = Oracle.of(parts, start).withHeapsUpTo(TurnTruth.HEAP);
        Advance exact = TurnTruth.exact(parts, start);
        Bodies resting = null;
        int[] turns = new int[rungs.size()];
        Bodies[] bodies = new Bodies[turns.length];
        Arrays.fill(turns, bound + 1);
        for (int r = 0; r < turns.length; r++) {
            bodies[r] = start.copy();
        }
        boolean some = true;
        for (int turn = 1; turn <= bound && some && (resting != null || !oracle.limited()); turn++) {
            Bodies before = resting == null ? rounded(start, truth) : resting;
            if (resting == null) {
                oracle.turn(truth);
            }
            if (resting != null || oracle.rested()) {
                resting = before;
                exact.turn(resting, TurnSink.NONE);
                truth = OracleBody.of(resting);
            }
            some = false;
            for (int r = 0; r < turns.length && (resting != null || !oracle.limited()); r++) {
                if (turns[r] > bound) {
                    rungs.get(r).turn(bodies[r], TurnSink.NONE);
                    turns[r] = isOff(bodies[r], truth) ? turn : turns[r];
                    some |= turns[r] > bound;
                }
            }
        }
        return turns;
    }

    /** Truth as doubles, as long as the bodies are those of the start. */
    private static Bodies rounded(Bodies start, List<OracleBody> truth) {
        Bodies bodies = start.copy();
        for (int k = 0; k < truth.size() && truth.size() == bodies.size(); k++) {
            bodies.setPosition(k, truth.get(k).x.doubleValue(), truth.get(k).y.doubleValue());
            bodies.setVelocity(k, truth.get(k).vx.doubleValue(), truth.get(k).vy.doubleValue());
        }
        return bodies;
    }

    private static boolean isOff(Bodies bodies, List<OracleBody> truth) {
        if (bodies.size() != truth.size()) {
            return true;                              // a reaction has removed or added another body
        }
        for (int k = 0; k < truth.size(); k++) {
            double dx = bodies.x[k] - truth.get(k).x.doubleValue();
            double dy = bodies.y[k] - truth.get(k).y.doubleValue();
            if (!(dx * dx + dy * dy <= OFF * OFF)) {
                return true;
            }
        }
        return false;
    }
}
