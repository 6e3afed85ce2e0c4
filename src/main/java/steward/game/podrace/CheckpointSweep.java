package steward.game.podrace;

import steward.physics.TurnLog;

/** Tests whether a pod's path inside a turn, a polyline, passes a checkpoint. Allocates nothing. */
public final class CheckpointSweep {

    private CheckpointSweep() {
    }

    /**
     * @param log    the knots of all bodies' paths between start and end
     * @param bodyId the body whose path is tested
     * @param radius of the checkpoint; a distance of exactly this counts
     */
    static boolean passes(TurnLog log, int bodyId, double startX, double startY, double endX, double endY,
                          double checkpointX, double checkpointY, double radius) {
        double fromX = startX;
        double fromY = startY;
        for (int k = 0; k < log.knots(); k++) {
            if (log.knotBody(k) == bodyId) {
                double toX = log.knotX(k);
                double toY = log.knotY(k);
                if (distance(checkpointX, checkpointY, fromX, fromY, toX, toY) <= radius) {
                    return true;
                }
                fromX = toX;
                fromY = toY;
            }
        }
        return distance(checkpointX, checkpointY, fromX, fromY, endX, endY) <= radius;
    }

    /** Distance of a point from the segment a-b, which may be a point. */
    public static double distance(double x, double y, double ax, double ay, double bx, double by) {
        double dx = bx - ax;
        double dy = by - ay;
        double square = dx * dx + dy * dy;
        double share = square == 0 ? 0 : Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / square));
        double offX = ax + share * dx - x;
        double offY = ay + share * dy - y;
        return Math.sqrt(offX * offX + offY * offY);
    }
}
