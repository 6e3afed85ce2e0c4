package steward.game.podrace.simulator;

import java.util.Arrays;
import steward.game.podrace.CheckpointSweep;
import steward.game.podrace.RulesEdition;
import steward.physics.TurnLog;
import steward.physics.TurnSink;
import steward.physics.event.FarPairs;

/** Corners of the pods' paths in a turn, for checkpoints; whole impacts are kept only if they are asked for. */
final class PodPaths implements TurnSink {

    private static final double CLEARANCE = 0.1;
    /**
     * The filter sets a path aside if the true square of its distance is above that of the radius by 0.9 u^2. The
     * rules' formula has squares of the path's length in it, which round by less than 2^-50 of them: up to here by
     * less than 0.9. Longer paths, in u, are not filtered.
     */
    static final double LONG = 0x1p24;

    private final TurnLog log;
    private final double radius;
    private final double reachOfPath;
    private final double reachOfEnd;
    private boolean recorded;

    private int[] pods = new int[32];
    private double[] times = new double[32];
    private double[] x = new double[32];
    private double[] y = new double[32];
    private int corners;
    /** Knots told, of which some stand at the same corner. */
    private int knots;
    /** By pod: the last corner, -1 for none. */
    private final int[] last;

    /**
     * @param pods   how many there are
     * @param log    receives everything while it is recorded
     * @param radius of checkpoints
     * @param rules  say which distances pass one
     */
    PodPaths(int pods, TurnLog log, double radius, RulesEdition rules) {
        last = new int[pods];
        Arrays.fill(last, -1);
        this.log = log;
        this.radius = radius;
        reachOfPath = rules.reachOfPath(radius);
        reachOfEnd = rules.reachOfEnd(radius);
    }

    boolean areRecorded() {
        return recorded;
    }

    void record(boolean wanted) {
        recorded = wanted;
    }

    /** A turn begins. */
    void clear() {
        if (corners > 0) {
            Arrays.fill(last, -1);
        }
        corners = 0;
        knots = 0;
        if (recorded) {
            log.clear();
        }
    }

    @Override
    public void impact(double time, int a, int b, double ax, double ay, double bx, double by,
                       double normalX, double normalY, double impulse, double energy, double massA, double massB,
                       double vaxBefore, double vayBefore, double vaxAfter, double vayAfter,
                       double vbxBefore, double vbyBefore, double vbxAfter, double vbyAfter) {
        if (recorded) {
            log.impact(time, a, b, ax, ay, bx, by, normalX, normalY, impulse, energy, massA, massB,
                vaxBefore, vayBefore, vaxAfter, vayAfter, vbxBefore, vbyBefore, vbxAfter, vbyAfter);
        }
    }

    /** A later one at the same time replaces a corner. */
    @Override
    public void knot(int pod, double time, double cornerX, double cornerY) {
        knots++;
        int corner = last[pod];
        if (corner < 0 || times[corner] != time) {
            if (corners == pods.length) {
                grow();
            }
            corner = corners++;
            last[pod] = corner;
        }
        pods[corner] = pod;
        times[corner] = time;
        x[corner] = cornerX;
        y[corner] = cornerY;
        if (recorded) {
            log.knot(pod, time, cornerX, cornerY);
        }
    }

    private void grow() {
        pods = Arrays.copyOf(pods, 2 * corners);
        times = Arrays.copyOf(times, 2 * corners);
        x = Arrays.copyOf(x, 2 * corners);
        y = Arrays.copyOf(y, 2 * corners);
    }

    @Override
    public void impactLimit(double time, int[] bodyIds) {
        if (recorded) {
            log.impactLimit(time, bodyIds);
        }
    }

    /** Returns how many knots all paths have together: at least two for each impact. */
    int knots() {
        return knots;
    }

    /** The filter for impacts knows this too: a moving point, and one at rest. */
    private boolean mayPass(double fromX, double fromY, double toX, double toY, double checkpointX,
                            double checkpointY) {
        return !(Math.abs(toX - fromX) + Math.abs(toY - fromY) < LONG)
            || FarPairs.mayMeet(fromX - checkpointX, fromY - checkpointY, toX - fromX, toY - fromY, 1,
                radius * radius);
    }

    /** As {@link CheckpointSweep#passes}. */
    boolean passes(int pod, double startX, double startY, double endX, double endY, double checkpointX,
                   double checkpointY) {
        double fromX = startX;
        double fromY = startY;
        for (int k = 0; k < corners; k++) {
            if (pods[k] == pod) {
                if (passes(fromX, fromY, x[k], y[k], checkpointX, checkpointY)) {
                    return true;
                }
                fromX = x[k];
                fromY = y[k];
            }
        }
        return passes(fromX, fromY, endX, endY, checkpointX, checkpointY)
            || CheckpointSweep.distance(checkpointX, checkpointY, endX, endY) <= reachOfEnd;
    }

    /** Returns how near the path of a pod comes to a checkpoint, in u; infinite if it stays farther away by a tenth. */
    double nearest(int pod, double startX, double startY, double endX, double endY, double checkpointX,
                   double checkpointY) {
        double least = Double.POSITIVE_INFINITY;
        double fromX = startX;
        double fromY = startY;
        for (int k = 0; k <= corners; k++) {
            if (k == corners || pods[k] == pod) {
                double toX = k == corners ? endX : x[k];
                double toY = k == corners ? endY : y[k];
                if (FarPairs.mayMeet(fromX - checkpointX, fromY - checkpointY, toX - fromX, toY - fromY, 1,
                    (radius + CLEARANCE) * (radius + CLEARANCE))) {
                    least = Math.min(least,
                        CheckpointSweep.distance(checkpointX, checkpointY, fromX, fromY, toX, toY));
                }
                fromX = toX;
                fromY = toY;
            }
        }
        return least;
    }

    private boolean passes(double fromX, double fromY, double toX, double toY, double checkpointX,
                           double checkpointY) {
        return mayPass(fromX, fromY, toX, toY, checkpointX, checkpointY)
            && CheckpointSweep.distance(checkpointX, checkpointY, fromX, fromY, toX, toY) <= reachOfPath;
    }
}
