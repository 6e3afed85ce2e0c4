package steward.game.podrace;

import java.util.ArrayList;
import java.util.List;
import steward.physics.HalfPlane;

/**
 * Whether a pod can come near enough to a checkpoint. A checkpoint is out of reach for sure if all places that count
 * are in one obstacle, or beyond two straight walls; passages too narrow for a pod are not looked for.
 */
final class CheckpointReach {

    /** Of the straight walls that a checkpoint is too near to, so many are compared in pairs; a box has two. */
    private static final int MOST_PAIRED = 16;

    private final double podRadius;
    private final double checkpointRadius;
    private final int jitter;
    private final List<Obstacle> obstacles;

    CheckpointReach(PodRaceSettings settings, List<Obstacle> obstacles) {
        podRadius = settings.radius();
        checkpointRadius = settings.checkpointRadius();
        jitter = settings.jitter();
        this.obstacles = obstacles;
    }

    /** What keeps pods from a checkpoint at one of the places that jitter gives it, or {@code null}. */
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
            least = Math.min(least,
                obstacle.gap().of(x + jitter * (k % 3 - 1), y + jitter * (k / 3 - 1), podRadius));
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
