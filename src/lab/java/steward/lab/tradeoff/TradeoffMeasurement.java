package steward.lab.tradeoff;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import steward.lab.oracle.TurnTruth;
import steward.lab.timing.RungJob;
import steward.lab.timing.Timing;
import steward.lab.timing.TimingSamples;
import steward.physics.Advance;
import steward.physics.Bodies;
import steward.physics.PhysicsParts;
import steward.scene.Accuracy;

/** Measurement of all rungs on one scene. Errors and costs come from the same states, which are drawn first. */
public final class TradeoffMeasurement {

    private static final int LEAST_STATES = 3;
    /** States whose true turn reaches the law's limit on impacts are replaced, this many times at most. */
    private static final int TRIES = 10;

    private final TradeoffScene scene;
    private final Timing<RungJob> timing;
    private final List<Accuracy> ladder;
    private final int states;
    private final int freeRuns;
    private final int freeTurns;

    /**
     * @param effort how much of the scene's states and free runs
     * @param timing times the job of each rung
     */
    public TradeoffMeasurement(TradeoffScene scene, TradeoffEffort effort, Timing<RungJob> timing) {
        this.scene = scene;
        this.timing = timing;
        ladder = Accuracy.ladder().stream().filter(rung -> rung.steps() <= scene.mostSteps()).toList();
        states = effort.of(scene.states(), LEAST_STATES);
        freeRuns = effort.of(scene.freeRuns(), 1);
        freeTurns = effort.of(scene.freeTurns(), 5);
    }

    /** Returns how many steps of progress {@link #run} makes. */
    public int steps() {
        return states + weight() * (freeRuns + timing.steps(ladder.size()));
    }

    /** Returns how many states take about as long as a free run, a warm-up or a round of timing. */
    private int weight() {
        return 1 + states / 20;
    }

    private void big(Runnable step) {
        for (int k = 0; k < weight(); k++) {
            step.run();
        }
    }

    /**
     * Measures the scene.
     *
     * @param step called after each step
     * @return a row per rung, in the order of the ladder
     */
    public List<TradeoffRow> run(Runnable step) {
        Bodies first = scene.source().get();
        List<Advance> rungs = ladder.stream().map(rung -> advance(rung, first.size())).toList();
        List<TradeoffErrors> errors = rungs.stream()
            .map(rung -> new TradeoffErrors(rung, scene.motion(), states)).toList();
        List<Bodies> starts = new ArrayList<>();
        long impacts = 0;
        for (int tries = 0; starts.size() < states && tries < TRIES * states; tries++) {
            Bodies start = tries == 0 ? first : scene.source().get();
            TurnTruth truth = TurnTruth.of(start, scene.parts());
            if (!truth.limited()) {
                starts.add(start);
                impacts += truth.impacts();
                errors.forEach(each -> each.add(start, truth));
                step.run();
            }
        }
        if (starts.isEmpty()) {
            throw new IllegalStateException(scene.name() + ": every turn came to the bound on impacts");
        }
        int[] free = freeRuns(starts, rungs, step);
        TimingSamples samples = timing.run(ladder.stream()
            .map(rung -> new RungJob(scene.inChild(), rung, first.size(), starts)).toList(), () -> big(step));
        return rows(errors, samples, impacts, free);
    }

    private List<TradeoffRow> rows(List<TradeoffErrors> errors, TimingSamples samples, long impacts, int[] free) {
        TradeoffRow.Cost[] cost = new TradeoffRow.Cost[errors.size()];
        double[][] jvms = new double[cost.length][];
        double[] nanos = new double[cost.length];
        double[] off = new double[cost.length];
        int usual = ladder.stream().map(Accuracy::text).toList().indexOf(TradeoffRow.DEFAULT_RUNG);
        for (int r = 0; r < cost.length; r++) {
            long computed = errors.get(r).computed();
            jvms[r] = samples.medians(r);
            double[] sorted = Arrays.stream(jvms[r]).sorted().toArray();
            nanos[r] = sorted[(sorted.length - 1) / 2];
            cost[r] = new TradeoffRow.Cost(nanos[r], sorted[0], sorted[sorted.length - 1],
                computed == 0 ? Double.NaN : nanos[r] * errors.get(r).states() / computed, samples.bytes(r));
            off[r] = errors.get(r).quantile(0.99);
        }
        boolean[] front = front(nanos, off);
        return IntStream.range(0, cost.length).mapToObj(r -> errors.get(r).row(scene.name(), ladder.get(r).text(),
            impacts, samples, cost[r], ratios(nanos[r] / nanos[usual], jvms[r], jvms[usual]), free[r], freeTurns,
            front[r])).toList();
    }

    /** With the range over the JVMs that were measured in the same rounds. */
    private static double[] ratios(double middle, double[] nanos, double[] usual) {
        double[] ratios = {middle, middle, middle};
        for (int jvm = 0; jvm < nanos.length; jvm++) {
            ratios[1] = Math.min(ratios[1], nanos[jvm] / usual[jvm]);
            ratios[2] = Math.max(ratios[2], nanos[jvm] / usual[jvm]);
        }
        return ratios;
    }

    private int[] freeRuns(List<Bodies> starts, List<Advance> rungs, Runnable step) {
        int[][] turns = new int[rungs.size()][freeRuns];
        for (int run = 0; run < freeRuns; run++) {
            int[] of = TradeoffFreeRun.turns(starts.get(run * starts.size() / freeRuns), scene.parts(), rungs,
                freeTurns);
            for (int r = 0; r < of.length; r++) {
                turns[r][run] = of[r];
            }
            big(step);
        }
        int[] median = new int[turns.length];
        for (int r = 0; r < median.length; r++) {
            Arrays.sort(turns[r]);
            median[r] = turns[r][freeRuns / 2];
        }
        return median;
    }

    private Advance advance(Accuracy rung, int bodies) {
        PhysicsParts parts = scene.parts();
        return rung.advance(parts.withArithmetic(rung.arithmetic()), bodies);
    }

    /**
     * Returns which points are on the Pareto front of cost and error: those that no other point beats in one respect
     * while being at least as good in the other. Equal points are on it together; NaN never is.
     */
    static boolean[] front(double[] cost, double[] error) {
        boolean[] front = new boolean[cost.length];
        for (int i = 0; i < front.length; i++) {
            front[i] = cost[i] == cost[i] && error[i] == error[i];
            for (int j = 0; j < front.length && front[i]; j++) {
                front[i] = !(cost[j] <= cost[i] && error[j] <= error[i] && (cost[j] < cost[i] || error[j] < error[i]));
            }
        }
        return front;
    }
}
