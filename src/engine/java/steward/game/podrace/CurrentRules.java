package steward.game.podrace;

import steward.numerics.SineCosine;
import steward.physics.TurnLog;

/** The rules of the server, in the edition of the scene. */
final class CurrentRules extends RaceRules {

    private final SineCosine direction = new SineCosine();
    private final double reachOfPath;
    private final double reachOfEnd;

    CurrentRules(PodRaceSettings settings) {
        reachOfPath = settings.rules().reachOfPath(settings.checkpointRadius());
        reachOfEnd = settings.rules().reachOfEnd(settings.checkpointRadius());
    }

    @Override
    void point(double heading) {
        direction.turn(heading);
        cos = direction.cos();
        sin = direction.sin();
    }

    @Override
    double[][] start(double[][] checkpoints, int pods) {
        return StartPlaces.of(checkpoints, pods);
    }

    /** Lines before a bad one take effect. */
    @Override
    boolean countsWhenOut() {
        return true;
    }

    @Override
    boolean keepsMass() {
        return true;
    }

    /** Each once, on behind the finish. */
    @Override
    int mostPasses(int passed, int toFinish, int checkpoints) {
        return checkpoints;
    }

    @Override
    boolean passes(TurnLog log, int bodyId, double startX, double startY, double endX, double endY,
                   double checkpointX, double checkpointY) {
        return CheckpointSweep.passes(log, bodyId, startX, startY, endX, endY, checkpointX, checkpointY, reachOfPath,
            reachOfEnd);
    }

    /** All players who are out share the last rank. */
    @Override
    boolean isAhead(RaceStanding standing, PodRace race, int one, int other) {
        if (!race.isIn(one) || !race.isIn(other)) {
            return race.isIn(one) && !race.isIn(other);
        }
        return standing.isBetter(standing.bestPod(one), standing.bestPod(other));
    }
}
