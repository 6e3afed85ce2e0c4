package steward.lab.tradeoff;

import java.util.Arrays;
import steward.lab.oracle.TurnError;
import steward.lab.oracle.TurnTruth;
import steward.lab.timing.TimingSamples;
import steward.physics.Advance;
import steward.physics.Bodies;
import steward.physics.Motion;
import steward.physics.TurnLog;

/** Errors of one rung, collected state by state. */
final class TradeoffErrors {

    private final Advance advance;
    private final Motion motion;
    private final double[] positions;
    private final TurnLog log = new TurnLog();
    private int states;
    private long computed;
    private long missed;
    private long invented;
    private double energy;
    private long differing;
    private long compared;

    /** @param motion may be {@code null}: then no final numbers are compared */
    TradeoffErrors(Advance advance, Motion motion, int most) {
        this.advance = advance;
        this.motion = motion;
        positions = new double[most];
    }

    /** Plays a turn and compares it with the true one. */
    void add(Bodies start, TurnTruth truth) {
        Bodies after = start.copy();
        log.clear();
        advance.turn(after, log);
        TurnError error = truth.error(after, log);
        positions[states++] = error.position();
        computed += log.impacts();
        missed += error.missed();
        invented += error.invented();
        energy = Math.max(energy, error.energy());
        if (motion != null) {
            motion.endTurn(after);
            differing += truth.differing(start, after, motion);
            for (int k = 0; k < start.size(); k++) {
                compared += start.mass[k] < Double.POSITIVE_INFINITY ? 1 : 0;
            }
        }
    }

    /** The error that this share of the turns does not exceed, 0 < share <= 1. */
    double quantile(double share) {
        double[] sorted = Arrays.copyOf(positions, states);
        Arrays.sort(sorted);
        return sorted[(int) Math.ceil(share * states) - 1];
    }

    /** Returns how many impacts the rung has computed. */
    long computed() {
        return computed;
    }

    /** Returns how many states there were. */
    int states() {
        return states;
    }

    /** @param ratios of the cost: that of the middle JVMs, the least, the greatest */
    TradeoffRow row(String scene, String rung, long impacts, TimingSamples samples, TradeoffRow.Cost cost,
                    double[] ratios, int freeTurns, int freeBound, boolean onFront) {
        return new TradeoffRow(scene, rung, states, impacts, samples.repeats(), samples.rounds(), cost, ratios[0],
            ratios[1], ratios[2], quantile(0.5), quantile(0.99), quantile(1), missed, invented, energy, freeTurns,
            freeBound, differing, compared, onFront);
    }
}
