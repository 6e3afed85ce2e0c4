package steward.game.podrace;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import steward.physics.HalfPlane;
import steward.scene.Field;

/**
 * Reachability of a checkpoint: true if a pod can come near enough to it. A checkpoint is out of reach for sure if all
 * places that count are in one obstacle, or beyond two straight walls, or parted from the starts by obstacles with no
 * gap for a pod.
 */
final class CheckpointReach {

    /** Of the straight walls that a checkpoint is too near to, so many are compared in pairs; a box has two. */
    private static final int MOST_PAIRED = 16;

    /**
     * By so much less than a pod's radius obstacles are grown where gaps are looked for, in u: positions are rounded,
     * by at most 0.71, and a gap that a pod is only just too large for is no certain barrier.
     */
    private static final double ROUNDING = 2;
    /** Steps for gaps, of 10 to 50 ns; when they are used up, the other checkpoints are taken to be in reach. */
    private static final long MOST_WORK = 5_000_000;
    private static final int NONE = -1;

    private final PodRaceSettings settings;
    private final double podRadius;
    private final double checkpointRadius;
    private final int jitter;
    private final List<Obstacle> obstacles;
    private final FreePlaces free;

    /**
     * @param field in which pods bounce at exact times, or {@code null}: between fixed steps pods may pass through
     *              walls, so that nothing shuts them in for sure
     */
    CheckpointReach(PodRaceSettings settings, List<Obstacle> obstacles, Field field) {
        this.settings = settings;
        podRadius = settings.radius();
        checkpointRadius = settings.checkpointRadius();
        jitter = settings.jitter();
        this.obstacles = obstacles;
        free = field == null ? null : new FreePlaces(field, obstacles, podRadius - ROUNDING, MOST_WORK);
    }

    /**
     * For each checkpoint of a map, a first checkpoint of a race from whose start no pod comes to it, whatever the
     * jitter; below 0 where all do or it is not certain.
     */
    int[] shutOut(double[][] map) {
        int[] shutOut = new int[map.length];
        Arrays.fill(shutOut, NONE);
        if (free == null || free.isOne() || free.isExhausted()) {
            return shutOut;
        }
        BitSet[] around = new BitSet[map.length];
        for (int k = 0; k < map.length; k++) {
            around[k] = new BitSet();
            free.addParts(map[k][0], map[k][1], counts(), around[k]);
        }
        for (int first = settings.shift() ? map.length - 1 : 0; first >= 0; first--) {
            double[][] ends = {map[first], map[(first + 1) % map.length]};
            double[][] starts = StartPlaces.of(ends, settings.pods());
            double[] slack = new double[starts.length];
            BitSet begun = begun(ends, starts, slack);
            for (int k = 0; k < map.length; k++) {
                if (!begun.isEmpty() && !around[k].intersects(begun) && !isNear(starts, slack, map[k])) {
                    shutOut[k] = first;
                }
            }
        }
        if (free.isExhausted()) {
            Arrays.fill(shutOut, NONE);
        }
        return shutOut;
    }

    /** Returns how near to a checkpoint without jitter a pod that reaches it can be at most. */
    private double counts() {
        return checkpointRadius + ROUNDING + jitter * Math.sqrt(2);
    }

    private BitSet begun(double[][] ends, double[][] starts, double[] slack) {
        double dx = ends[1][0] - ends[0][0];
        double dy = ends[1][1] - ends[0][1];
        BitSet begun = new BitSet();
        for (int pod = 0; pod < starts.length; pod++) {
            slack[pod] = StartPlaces.slack(StartPlaces.side(pod, starts.length), jitter, Math.sqrt(dx * dx + dy * dy));
            free.addPart(starts[pod][0], starts[pod][1], begun);
            if (jitter > 0) {
                free.addParts(starts[pod][0], starts[pod][1], slack[pod] + ROUNDING, begun);
            }
        }
        return begun;
    }

    /** True if a pod may start where the checkpoint counts. */
    private boolean isNear(double[][] starts, double[] slack, double[] checkpoint) {
        for (int pod = 0; pod < starts.length; pod++) {
            double dx = starts[pod][0] - checkpoint[0];
            double dy = starts[pod][1] - checkpoint[1];
            if (Math.sqrt(dx * dx + dy * dy) <= counts() + slack[pod] + ROUNDING) {
                return true;
            }
        }
        return false;
    }

    /** Names the obstacle that keeps pods from a checkpoint at one of the places that jitter gives it, or {@code null}.
     */
    String barrier(double x, double y) {
        List<HalfPlane> near = new ArrayList<>();
        for (Obstacle obstacle : obstacles) {
            double gap = obstacle.gap().of(x, y, podRadius);
            double farthest = gap - jitter * Math.sqrt(2);
            if (farthest + checkpointRadius < 0 && least(obstacle, x, y) + checkpointRadius < 0) {
                return obstacle.name();
            }
            if (farthest < 0 && obstacle.wall() instanceof HalfPlane wall && near.size() < MOST_PAIRED) {
                near.add(wall);
            }
        }
        for (int i = 1; i < near.size(); i++) {
            for (int j = 0; j < i; j++) {
                if (mostToCorner(near.get(i), near.get(j), x, y) > checkpointRadius) {
                    return "two walls, in their corner";
                }
            }
        }
        return null;
    }

    /** The least gap over the corners of the square of jitter, its middle and the middles of its sides. */
    private double least(Obstacle obstacle, double x, double y) {
        double least = Double.POSITIVE_INFINITY;
        for (int k = 0; k < 9; k++) {
            least = Math.min(least, obstacle.gap().of(x + jitter * (k % 3 - 1), y + jitter * (k / 3 - 1), podRadius));
        }
        return least;
    }

    /** The greatest distance to the places inside two walls, over the corners of the square of jitter. */
    private double mostToCorner(HalfPlane a, HalfPlane b, double x, double y) {
        double most = 0;
        for (int k = 0; k < 4; k++) {
            most = Math.max(most, toCorner(a, b, x + jitter * (2 * (k % 2) - 1), y + jitter * (2 * (k / 2) - 1)));
        }
        return most;
    }

    /*
     * Inside both walls the nearest place to a point is the point itself, its projection on one wall if that is inside
     * the other, or the corner: the point moved by m with m . na = -ga and m . nb = -gb, where n are the unit vectors
     * inward and g the gaps (Cramer's rule).
     */
    private double toCorner(HalfPlane a, HalfPlane b, double x, double y) {
        double ga = a.gap(x, y, podRadius);
        double gb = b.gap(x, y, podRadius);
        double cosine = a.insideX() * b.insideX() + a.insideY() * b.insideY();
        double sine = a.insideX() * b.insideY() - a.insideY() * b.insideX();
        if (ga >= 0 && gb >= 0) {
            return 0;
        }
        if (ga < 0 && gb - ga * cosine >= 0) {
            return -ga;
        }
        if (gb < 0 && ga - gb * cosine >= 0) {
            return -gb;
        }
        if (sine == 0) {
            return 0;
        }
        double moveX = (gb * a.insideY() - ga * b.insideY()) / sine;
        double moveY = (ga * b.insideX() - gb * a.insideX()) / sine;
        return Math.sqrt(moveX * moveX + moveY * moveY);
    }
}
