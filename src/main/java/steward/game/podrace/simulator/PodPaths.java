package steward.game.podrace.simulator;

import java.util.Arrays;
import steward.game.podrace.CheckpointSweep;
import steward.physics.TurnLog;
import steward.physics.TurnSink;
import steward.physics.event.OfficialAdvance;

/** The corners of the pods' paths in a turn, for checkpoints; impacts are kept only while they are recorded. */
final class PodPaths implements TurnSink {

    private static final double CLEARANCE = 0.1;

    private final TurnLog log;
    private final double radius;
    private boolean recorded;

    private int[] pods = new int[32];
    private double[] x = new double[32];
    private double[] y = new double[32];
    private int corners;

    /**
     * @param log    receives impacts and corners while they are recorded
     * @param radius of checkpoints
     */
    PodPaths(TurnLog log, double radius) {
        this.log = log;
        this.radius = radius;
    }

    boolean areRecorded() {
        return recorded;
    }

    void record(boolean wanted) {
        recorded = wanted;
        log.clear();
    }

    /** Begins a turn. */
    void clear() {
        corners = 0;
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

    @Override
    public void knot(int pod, double time, double cornerX, double cornerY) {
        if (corners == pods.length) {
            pods = Arrays.copyOf(pods, 2 * corners);
            x = Arrays.copyOf(x, 2 * corners);
            y = Arrays.copyOf(y, 2 * corners);
        }
        pods[corners] = pod;
        x[corners] = cornerX;
        y[corners] = cornerY;
        corners++;
        if (recorded) {
            log.knot(pod, time, cornerX, cornerY);
        }
    }

    @Override
    public void impactLimit(double time, int[] bodyIds) {
        if (recorded) {
            log.impactLimit(time, bodyIds);
        }
    }

    /** The number of corners of all paths: at least two for each impact. */
    int corners() {
        return corners;
    }

    /** The filter for impacts, applied to a moving point and a checkpoint at rest. */
    private boolean mayPass(double fromX, double fromY, double toX, double toY, double checkpointX,
                            double checkpointY) {
        return OfficialAdvance.mayMeet(fromX - checkpointX, fromY - checkpointY, toX - fromX, toY - fromY, 1,
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
        return passes(fromX, fromY, endX, endY, checkpointX, checkpointY);
    }

    /**
     * The least distance of a pod's path from the centre of a checkpoint, in u; may be infinite if it exceeds the
     * radius by more than {@link #CLEARANCE}.
     */
    double nearest(int pod, double startX, double startY, double endX, double endY, double checkpointX,
                   double checkpointY) {
        double least = Double.POSITIVE_INFINITY;
        double fromX = startX;
        double fromY = startY;
        for (int k = 0; k <= corners; k++) {
            if (k == corners || pods[k] == pod) {
                double toX = k == corners ? endX : x[k];
                double toY = k == corners ? endY : y[k];
                if (OfficialAdvance.mayMeet(fromX - checkpointX, fromY - checkpointY, toX - fromX, toY - fromY, 1,
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
            && CheckpointSweep.distance(checkpointX, checkpointY, fromX, fromY, toX, toY) <= radius;
    }
}
