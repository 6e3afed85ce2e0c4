package steward.lab.capacity;

import java.util.ArrayList;
import java.util.List;
import steward.lab.capacity.CapacitySimulation.Load;
import steward.lab.capacity.CapacitySimulation.Setting;
import steward.lab.capacity.LeagueCosts.Part;

/**
 * Simulated load of a league's process, row by row with more and more workers.
 *
 * @param costs      of a game
 * @param processors of the league's machine
 * @param rows       one for each number of workers, ascending
 * @param last       all workers together with no more games than one of them has in {@code rows}
 * @param larger     all workers, and a league's machine with more processors
 */
public record SaturationTable(LeagueCosts costs, int processors, List<Row> rows, Row last, List<Row> larger) {

    /** Games of a row; the mean delay below saturation is known to some percent then. */
    private static final int GAMES = 20_000;
    private static final long SEED = 1;
    /** Where nothing is busy for so much of the time, there are not enough games under way. */
    private static final double FULL = 0.9;
    private static final List<Part> PARTS = List.of(Part.PROCESSORS, Part.MESSAGES, Part.SCHEDULE, Part.STORE,
        Part.WORKERS);
    private static final int[] STEPS = {1, 2, 5};
    private static final List<Integer> LARGER = List.of(2, 4, 8, 16, 32);

    /**
     * A simulation.
     *
     * @param processors of the league's machine
     * @param workers    one game at a time each
     * @param offered    games in a second that they could play
     * @param load       what came of it
     * @param first      what has no time left
     */
    public record Row(int processors, int workers, double offered, Load load, Part first) {

        static Row of(LeagueCosts costs, int processors, int workers, double perSecond, int places) {
            Load load = CapacitySimulation.of(costs, new Setting(processors, workers, 1e9 / perSecond, places), GAMES,
                SEED);
            double[] busy = {load.processors(), load.messages(), load.schedule(), load.store(), load.workers()};
            int most = 0;
            for (int k = 1; k < busy.length; k++) {
                most = busy[k] > busy[most] ? k : most;
            }
            Part part = busy[most] < FULL ? Part.PLACES : PARTS.get(most);
            return new Row(processors, workers, workers * perSecond, load, part);
        }
    }

    /**
     * Simulates.
     *
     * @param workers   the largest number of workers
     * @param perSecond games that one of them plays in a second
     * @param places    games that may be under way at most
     * @param step      called after each simulation
     */
    public static SaturationTable of(LeagueCosts costs, int processors, int workers, double perSecond, int places,
                                     Runnable step) {
        List<Row> rows = new ArrayList<>();
        for (int count : counts(workers)) {
            rows.add(Row.of(costs, processors, count, perSecond, places));
            step.run();
        }
        Row last = Row.of(costs, processors, workers, perSecond / workers, places);
        step.run();
        List<Row> larger = new ArrayList<>();
        for (int factor : LARGER) {
            larger.add(Row.of(costs, factor * processors, workers, perSecond, places));
            step.run();
        }
        return new SaturationTable(costs, processors, rows, last, larger);
    }

    /** 1, 2, 5, 10, 20, 50, ... up to the largest. */
    static List<Integer> counts(int largest) {
        List<Integer> counts = new ArrayList<>();
        for (long unit = 1; unit < largest; unit *= 10) {
            for (int step : STEPS) {
                if (unit * step < largest) {
                    counts.add((int) (unit * step));
                }
            }
        }
        counts.add(largest);
        return counts;
    }

    /** Returns how many simulations {@link #of} makes. */
    public static int steps(int workers) {
        return counts(workers).size() + 1 + LARGER.size();
    }
}
