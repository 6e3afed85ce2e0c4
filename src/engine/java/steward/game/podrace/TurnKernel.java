package steward.game.podrace;

import steward.physics.Advance;
import steward.physics.Bodies;
import steward.physics.TurnLog;
import steward.scene.Plan;
import steward.scene.Scene;

/**
 * Fast way to play commands and motion of a turn, in scenes that it fits, with the bits of {@link PodRace}'s general
 * way. It keeps the headings of the pods; everything else is the race's.
 */
public interface TurnKernel {

    /** Choice of a kernel when a race is made. */
    interface Choice {

        /** The choice of the general way. */
        Choice NONE = (settings, scene, plan, checkpoints, advance, log) -> null;

        /**
         * Returns a kernel without headings, or {@code null} if the scene needs the general way.
         *
         * @param advance the race's own, which the kernel may use
         * @param log     the race's own
         */
        TurnKernel of(PodRaceSettings settings, Scene scene, Plan plan, double[][] checkpoints, Advance advance,
                      TurnLog log);
    }

    /** The exact heading of a pod in radians; NaN while unset. */
    double heading(int pod);

    /** Sets the heading of a pod in radians; NaN for unset. */
    void setHeading(int pod, double angle);

    /** Returns a kernel for a copy of the race, with its headings; the parameters as in {@link Choice#of}. */
    TurnKernel copy(Advance advance, TurnLog log);

    /**
     * Plays the commands and the motion up to the end of the turn, roundings included.
     *
     * @param passed checkpoints passed, by pod; stays as it is
     * @return the pods that may have passed their next checkpoint, as bits
     */
    int play(Bodies bodies, double[] targetX, double[] targetY, int[] thrust, int[] shieldTimer, boolean[] boostLeft,
             int[] passed);

    /** True if the path of a pod in the turn just played passes a checkpoint. */
    boolean passes(int pod, double checkpointX, double checkpointY);

    /** Logs the impacts and knots of the turn just played; headings have to be those after it. */
    void log();
}
