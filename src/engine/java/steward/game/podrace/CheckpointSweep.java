package steward.game.podrace;

import steward.physics.TurnLog;

/**
 * Tests whether a pod's path inside a turn passes near enough to a checkpoint. The path is a polyline with one corner
 * per impact, the place after positional correction; a later impact at the same time replaces it. Allocates nothing.
 */
public final class CheckpointSweep {

    private CheckpointSweep() { }

    /**
     * @param log         holds the knots of the path between start and end, those of all bodies
     * @param bodyId      whose path
     * @param reachOfPath distances of a segment up to and including this count
     * @param reachOfEnd  and those of the end; below 0 for none
     */
    static boolean passes(TurnLog log, int bodyId, double startX, double startY, double endX, double endY,
                          double checkpointX, double checkpointY, double reachOfPath, double reachOfEnd) {
        double fromX = startX;
        double fromY = startY;
        int corner = -1;
        for (int k = 0; k < log.knots(); k++) {
            if (log.knotBody(k) == bodyId) {
                if (corner >= 0 && log.knotTime(corner) != log.knotTime(k)) {
                    double toX = log.knotX(corner);
                    double toY = log.knotY(corner);
                    if (distance(checkpointX, checkpointY, fromX, fromY, toX, toY) <= reachOfPath) {
                        return true;
                    }
                    fromX = toX;
                    fromY = toY;
                }
                corner = k;
            }
        }
        if (corner >= 0) {
            double toX = log.knotX(corner);
            double toY = log.knotY(corner);
            if (distance(checkpointX, checkpointY, fromX, fromY, toX, toY) <= reachOfPath) {
                return true;
            }
            fromX = toX;
            fromY = toY;
        }
        return distance(checkpointX, checkpointY, fromX, fromY, endX, endY) <= reachOfPath
            || distance(checkpointX, checkpointY, endX, endY) <= reachOfEnd;
    }

    public static double distance(double x, double y, double otherX, double otherY) {
        double dx = x - otherX;
        double dy = y - otherY;
        return Math.sqrt(dx * dx + dy * dy);
    }

    /*
     * The official referee takes the distance from the JDK, java.awt.geom.Line2D.ptSegDist, whose documented behaviour
     * fixes its bits. With d = b - a and e = p - a the projection of e on d has the square (e.d)^2 / d.d, and by
     * Pythagoras the square of the distance is e.e less that; beyond an end (e.d <= 0, seen from a or from b) the
     * distance is that from the end. The difference is never below 0.
     */

    /** Distance of a point from the segment a-b, which may be a single point; the bits of the official referee. */
    public static double distance(double x, double y, double ax, double ay, double bx, double by) {
        double dx = bx - ax;
        double dy = by - ay;
        double ex = x - ax;
        double ey = y - ay;
        double projected = 0;
        double along = ex * dx + ey * dy;
        if (along > 0) {
            ex = dx - ex;
            ey = dy - ey;
            along = ex * dx + ey * dy;
            if (along > 0) {
                projected = along * along / (dx * dx + dy * dy);
            }
        }
        return Math.sqrt(Math.max(0, ex * ex + ey * ey - projected));
    }
}
