package steward.lab.tradeoff;

import java.util.Arrays;
import java.util.List;
import steward.physics.Advance;
import steward.physics.Bodies;
import steward.physics.TurnSink;

/*
 * Every measured stretch plays up to BATCH turns from copies that were made before it, so that neither the copying nor
 * the clock is included. The rungs take turns in each round, so that a slow period of the machine affects all of them;
 * the result is the median of the rounds. The first, unmeasured stretches let the compiler see every rung.
 */

/**
 * Measures the costs of rungs on the same states. One JVM compiles for all of them, as in a program that uses several.
 */
final class TradeoffCosts {

    private static final int BATCH = 512;
    private static final double NANOS = 1e9;

    private final TradeoffClock clock = new TradeoffClock();
    private final List<Bodies> states;
    private final List<Advance> rungs;
    private final Bodies[] copies;
    private final double[][] nanos;
    private final double[] bytes;
    private int rounds;
    private double seconds;

    TradeoffCosts(List<Bodies> states, List<Advance> rungs, int rounds) {
        this.states = states;
        this.rungs = rungs;
        copies = states.stream().limit(BATCH).map(Bodies::copy).toArray(Bodies[]::new);
        nanos = new double[rungs.size()][rounds];
        bytes = new double[rungs.size()];
        Arrays.fill(bytes, clock.tellsBytes() ? Double.POSITIVE_INFINITY : Double.NaN);
    }

    /** Runs a rung without measuring, for at least the given number of seconds. */
    void warmUp(int rung, double least) {
        run(rung, least);
    }

    /** Duration of all rounds so far. */
    double seconds() {
        return seconds;
    }

    /** How many rounds there have been. */
    int rounds() {
        return rounds;
    }

    /** Measures every rung once, every other time in the opposite order. */
    void round(double least) {
        for (int k = 0; k < rungs.size(); k++) {
            int rung = rounds % 2 == 0 ? k : rungs.size() - 1 - k;
            Stretch all = run(rung, least);
            seconds += all.nanos / NANOS;
            nanos[rung][rounds] = (double) all.nanos / all.turns;
            if (clock.tellsBytes()) {
                bytes[rung] = Math.min(bytes[rung], (double) all.bytes / all.turns);
            }
        }
        rounds++;
    }

    /** @param nanos of CPU */
    private record Stretch(long nanos, long bytes, long turns) {
    }

    private Stretch run(int rung, double least) {
        Advance advance = rungs.get(rung);
        long used = 0;
        long allocated = 0;
        long turns = 0;
        do {
            for (int from = 0; from < states.size(); from += copies.length) {
                int count = Math.min(copies.length, states.size() - from);
                for (int k = 0; k < count; k++) {
                    copies[k].copyFrom(states.get(from + k));
                }
                long bytesBefore = clock.bytes();
                long before = clock.nanos();
                for (int k = 0; k < count; k++) {
                    advance.turn(copies[k], TurnSink.NONE);
                }
                used += clock.nanos() - before;
                allocated += clock.bytes() - bytesBefore;
            }
            turns += states.size();
        } while (used < least * NANOS);
        return new Stretch(used, allocated, turns);
    }

    /**
     * What a turn costs: time is the median of the rounds; bytes are those of the round with the fewest, because the
     * JVM's own work (a discarded compiled method, a growing buffer) is no cost of a turn.
     *
     * @param computed how many impacts the rung computes in all states together
     */
    TradeoffRow.Cost cost(int rung, long computed) {
        double perTurn = median(Arrays.copyOf(nanos[rung], rounds));
        return new TradeoffRow.Cost(perTurn, computed == 0 ? Double.NaN : perTurn * states.size() / computed,
            bytes[rung]);
    }

    /** The time of a turn as a multiple of another rung's: the median of the ratios of the rounds. */
    double ratio(int rung, int other) {
        double[] ratios = new double[rounds];
        for (int round = 0; round < rounds; round++) {
            ratios[round] = nanos[rung][round] / nanos[other][round];
        }
        return median(ratios);
    }

    static double median(double[] values) {
        double[] sorted = values.clone();
        Arrays.sort(sorted);
        int half = sorted.length / 2;
        return sorted.length % 2 == 1 ? sorted[half] : (sorted[half - 1] + sorted[half]) / 2;
    }
}
