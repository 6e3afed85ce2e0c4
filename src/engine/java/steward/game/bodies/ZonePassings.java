package steward.game.bodies;

import java.util.Arrays;
import steward.physics.Bodies;
import steward.physics.TurnLog;

/**
 * Entries of discs into zones during a turn, from the paths of their centres: start, knots of the turn's log, end.
 * Entries are in the order of time, then of ids, then of zones.
 */
final class ZonePassings {

    private static final int NUMBERS = 3;

    private final Zone[] zones;
    /** By the id of a disc: the last corner of its path, and when it was there. */
    private final double[] x;
    private final double[] y;
    private final double[] since;
    private int[] discs = new int[8];
    private int[] entered = new int[8];
    /** Time and place of each. */
    private double[] numbers = new double[NUMBERS * 8];
    private int size;

    /** @param discs the number of discs before the first turn */
    ZonePassings(Zone[] zones, int discs) {
        this.zones = zones;
        x = new double[discs];
        y = new double[discs];
        since = new double[discs];
    }

    /** Begins a turn. @param first true in the first turn of a game: what is in a zone has entered it */
    void begin(Bodies bodies, boolean first) {
        size = 0;
        for (int k = 0; k < bodies.size() && bodies.id(k) < x.length; k++) {
            int id = bodies.id(k);
            x[id] = bodies.x[k];
            y[id] = bodies.y[k];
            since[id] = 0;
            for (int z = 0; first && z < zones.length; z++) {
                if (zones[z].holds(x[id], y[id])) {
                    add(id, z, 0, x[id], y[id]);
                }
            }
        }
    }

    /** Follows the paths to their last corners before the end of the turn. */
    void follow(TurnLog log) {
        for (int k = 0; k < log.knots(); k++) {
            if (log.knotBody(k) < x.length) {
                flyTo(log.knotBody(k), log.knotTime(k), log.knotX(k), log.knotY(k));
            }
        }
    }

    /** Follows the paths to where the bodies are at the end of the turn; also to where rounding then puts them. */
    void end(Bodies bodies) {
        for (int k = 0; k < bodies.size() && bodies.id(k) < x.length; k++) {
            flyTo(bodies.id(k), 1, bodies.x[k], bodies.y[k]);
        }
    }

    private void flyTo(int id, double time, double toX, double toY) {
        for (int z = 0; z < zones.length; z++) {
            double share = zones[z].entry(x[id], y[id], toX, toY);
            if (share >= 0) {
                add(id, z, since[id] + share * (time - since[id]), x[id] + share * (toX - x[id]),
                    y[id] + share * (toY - y[id]));
            }
        }
        x[id] = toX;
        y[id] = toY;
        since[id] = time;
    }

    /** Adds an entry at its place in the order: most come last. */
    private void add(int id, int zone, double time, double atX, double atY) {
        if (size == discs.length) {
            discs = Arrays.copyOf(discs, 2 * size);
            entered = Arrays.copyOf(entered, 2 * size);
            numbers = Arrays.copyOf(numbers, 2 * NUMBERS * size);
        }
        int k = size++;
        for (; k > 0 && isBefore(time, id, zone, k - 1); k--) {
            discs[k] = discs[k - 1];
            entered[k] = entered[k - 1];
            System.arraycopy(numbers, NUMBERS * (k - 1), numbers, NUMBERS * k, NUMBERS);
        }
        discs[k] = id;
        entered[k] = zone;
        numbers[NUMBERS * k] = time;
        numbers[NUMBERS * k + 1] = atX;
        numbers[NUMBERS * k + 2] = atY;
    }

    private boolean isBefore(double time, int id, int zone, int k) {
        return time != time(k) ? time < time(k) : id != discs[k] ? id < discs[k] : zone < entered[k];
    }

    int size() {
        return size;
    }

    /** The id of the disc of the k-th entry. */
    int disc(int k) {
        return discs[k];
    }

    Zone zone(int k) {
        return zones[entered[k]];
    }

    /** Returns when the k-th entry happened within the turn, 0..1. */
    double time(int k) {
        return numbers[NUMBERS * k];
    }

    double x(int k) {
        return numbers[NUMBERS * k + 1];
    }

    double y(int k) {
        return numbers[NUMBERS * k + 2];
    }
}
