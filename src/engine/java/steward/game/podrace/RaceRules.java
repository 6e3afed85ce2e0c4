package steward.game.podrace;

import steward.numerics.Angles;
import steward.physics.TurnLog;

/**
 * What the rules of the race are where two editions of them differ: today's, and those of replays of formats 1 and 2.
 */
abstract sealed class RaceRules permits CurrentRules, FormerRules {

    /** Sine and cosine of the last {@link #point}. */
    double cos;
    double sin;

    /** The edition that goes with these angles; it keeps the last sine and cosine, so each race has its own. */
    static RaceRules of(Angles angles, PodRaceSettings settings) {
        return angles == Angles.FDLIBM ? new FormerRules(settings.checkpointRadius()) : new CurrentRules(settings);
    }

    /** Computes sine and cosine of a heading, in radians. */
    abstract void point(double heading);

    /** Where pods stand at first, {@code [n][x, y]}. */
    abstract double[][] start(double[][] checkpoints, int pods);

    /** Whether a command counts that was given by a player who is out by the time the turn is played. */
    abstract boolean countsWhenOut();

    /** Whether a pod without a command keeps the mass it had. */
    abstract boolean keepsMass();

    /** How many checkpoints a pod may pass in a turn. */
    abstract int mostPasses(int passed, int toFinish, int checkpoints);

    /** As {@link CheckpointSweep#passes}. */
    abstract boolean passes(TurnLog log, int bodyId, double startX, double startY, double endX, double endY,
                            double checkpointX, double checkpointY);

    /** Whether one player is ahead of another. */
    abstract boolean isAhead(RaceStanding standing, PodRace race, int one, int other);
}
