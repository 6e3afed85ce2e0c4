package steward.game.podrace;

import steward.numerics.StrictAngles;
import steward.physics.TurnLog;

/**
 * The rules as they were when replays of formats 1 and 2 were made, so that these are played again as they were: angles
 * of fdlibm, every knot of a path a corner, another formula for the distance of a checkpoint, nothing counted behind
 * the finish, players ranked by the turn in which they went out.
 */
final class FormerRules extends RaceRules {

    private static final double START_OFFSET = 500;
    private static final double START_SPACING = 1000;

    private final StrictAngles direction = new StrictAngles();
    private final double radius;

    FormerRules(double checkpointRadius) {
        radius = checkpointRadius;
    }

    @Override
    void point(double heading) {
        direction.turn(heading);
        cos = direction.cos();
        sin = direction.sin();
    }

    /** Offsets -500, +500, -1500, ... for an odd number of pods too. */
    @Override
    double[][] start(double[][] checkpoints, int pods) {
        double dx = checkpoints[1][0] - checkpoints[0][0];
        double dy = checkpoints[1][1] - checkpoints[0][1];
        double length = Math.sqrt(dx * dx + dy * dy);
        double[][] places = new double[pods][];
        for (int pod = 0; pod < pods; pod++) {
            double offset = START_OFFSET + START_SPACING * (pod / 2);
            double side = pod % 2 == 0 ? -offset : offset;
            places[pod] = new double[] {Math.floor(checkpoints[0][0] - side * dy / length + 0.5),
                Math.floor(checkpoints[0][1] + side * dx / length + 0.5)};
        }
        return places;
    }

    @Override
    boolean countsWhenOut() {
        return false;
    }

    @Override
    boolean keepsMass() {
        return false;
    }

    @Override
    int mostPasses(int passed, int toFinish, int checkpoints) {
        return Math.max(0, toFinish - passed);
    }

    @Override
    boolean passes(TurnLog log, int bodyId, double startX, double startY, double endX, double endY,
                   double checkpointX, double checkpointY) {
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

    /** Distance of a point from the segment a-b: from the nearest point of the segment, computed as such. */
    private static double distance(double x, double y, double ax, double ay, double bx, double by) {
        double dx = bx - ax;
        double dy = by - ay;
        double square = dx * dx + dy * dy;
        double share = square == 0 ? 0 : Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / square));
        double offX = ax + share * dx - x;
        double offY = ay + share * dy - y;
        return Math.sqrt(offX * offX + offY * offY);
    }

    @Override
    boolean isAhead(RaceStanding standing, PodRace race, int one, int other) {
        if (standing.hasFinished(one) || standing.hasFinished(other)) {
            return standing.hasFinished(one) && !standing.hasFinished(other);
        }
        if (!race.isIn(one) || !race.isIn(other)) {
            return race.outTurn(one) > race.outTurn(other);
        }
        return standing.isBetter(standing.bestPod(one), standing.bestPod(other));
    }
}
