package steward.lab.tradeoff;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import steward.lab.oracle.TurnTruth;
import steward.physics.Advance;
import steward.physics.Bodies;
import steward.physics.PhysicsParts;
import steward.scene.Accuracy;

/** Measures all rungs on one scene. Errors and costs come from the same states, which are drawn first. */
public final class TradeoffMeasurement {

    private static final int LEAST_STATES = 3;
    private static final int LEAST_ROUNDS = 3;
    /** States whose true turn reaches the law's limit on impacts are replaced, this many times at most. */
    private static final int TRIES = 10;

    private final TradeoffScene scene;
    private final TradeoffEffort effort;
    private final List<Accuracy> ladder;
    private final int states;
    private final int freeRuns;
    private final int freeTurns;

    /** @param effort how much of the scene's states, rounds and free runs */
    public TradeoffMeasurement(TradeoffScene scene, TradeoffEffort effort) {
        this.scene = scene;
        this.effort = effort;
        ladder = Accuracy.ladder().stream().filter(rung -> rung.steps() <= scene.mostSteps()).toList();
        states = effort.of(scene.states(), LEAST_STATES);
        freeRuns = effort.of(scene.freeRuns(), 1);
        freeTurns = effort.of(scene.freeTurns(), 5);
    }

    /** How many steps of progress {@link #run} makes. */
    public int steps() {
        return states + weight() * (freeRuns + ladder.size() + effort.rounds());
    }

    /** How many states take about as long as a free run, a warm-up or a round. */
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
        TradeoffCosts costs = new TradeoffCosts(starts, rungs, effort.rounds());
        for (int rung = 0; rung < rungs.size(); rung++) {
            costs.warmUp(rung, effort.warmUp());
            big(step);
        }
        for (int round = 0; round < effort.rounds(); round++) {
            if (round < LEAST_ROUNDS || costs.seconds() < effort.budget()) {
                costs.round(effort.round());
            }
            big(step);
        }
        return rows(errors, costs, impacts, free);
    }

    private List<TradeoffRow> rows(List<TradeoffErrors> errors, TradeoffCosts costs, long impacts, int[] free) {
        TradeoffRow.Cost[] cost = new TradeoffRow.Cost[errors.size()];
        double[] nanos = new double[cost.length];
        double[] off = new double[cost.length];
        int usual = ladder.stream().map(Accuracy::text).toList().indexOf(TradeoffRow.DEFAULT_RUNG);
        for (int r = 0; r < cost.length; r++) {
            cost[r] = costs.cost(r, errors.get(r).computed());
            nanos[r] = cost[r].nanosPerTurn();
            off[r] = errors.get(r).quantile(0.99);
        }
        boolean[] front = ParetoFront.of(nanos, off);
        List<TradeoffRow> rows = new ArrayList<>();
        for (int r = 0; r < cost.length; r++) {
            rows.add(errors.get(r).row(scene.name(), ladder.get(r).text(), impacts, costs.rounds(), cost[r],
                costs.ratio(r, usual), free[r], freeTurns, front[r]));
        }
        return rows;
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
}
