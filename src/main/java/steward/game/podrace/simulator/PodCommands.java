package steward.game.podrace.simulator;

import java.util.Arrays;
import steward.game.podrace.PodRace;
import steward.game.podrace.PodRaceSettings;

/**
 * One command per pod, for a {@link PodRaceSimulator}: fill it, play it, fill it anew. A command stays until another is
 * set. A pod's target is where it steers, as in a bot's answer; at its own place it neither turns nor thrusts.
 */
public final class PodCommands {

    /** Instead of a thrust: no command, as of a player who is out. The pod drifts. */
    public static final int NO_COMMAND = PodRace.NO_COMMAND;
    /** Instead of a thrust: raise the shield. The pod weighs ten times as much, and has no thrust for a while. */
    public static final int SHIELD = PodRace.SHIELD;
    /** Instead of a thrust: boost, a thrust of 650 once in a race, and of 200 from then on. */
    public static final int BOOST = PodRace.BOOST;
    /** The greatest thrust. A race takes 0..200 from a bot. */
    public static final int GREATEST_THRUST = PodRaceSettings.BOOST_THRUST;

    final double[] targetX;
    final double[] targetY;
    final int[] thrust;

    /**
     * No command for any pod.
     *
     * @param pods how many there are, at least 1
     * @throws IllegalArgumentException if there are fewer
     */
    public PodCommands(int pods) {
        if (pods < 1) {
            throw new IllegalArgumentException(pods + " pods, expected at least 1");
        }
        targetX = new double[pods];
        targetY = new double[pods];
        thrust = new int[pods];
        clear();
    }

    /**
     * Sets the command of a pod.
     *
     * @param x         where to steer, in u; finite
     * @param y         where to steer, in u; finite
     * @param podThrust 0..{@link #GREATEST_THRUST}, {@link #SHIELD}, {@link #BOOST} or {@link #NO_COMMAND}
     * @throws IllegalArgumentException  if a number is not among these
     * @throws IndexOutOfBoundsException if there is no such pod
     */
    public void set(int pod, double x, double y, int podThrust) {
        check(pod, x, y, podThrust);
        targetX[pod] = x;
        targetY[pod] = y;
        thrust[pod] = podThrust;
    }

    /** Refuses what cannot be commanded. */
    static void check(int pod, double x, double y, int thrust) {
        if (!(Math.abs(x) <= Double.MAX_VALUE && Math.abs(y) <= Double.MAX_VALUE)) {
            throw new IllegalArgumentException("pod " + pod + ": target " + x + " " + y + ", expected finite numbers");
        }
        if (thrust < BOOST || thrust > GREATEST_THRUST) {
            throw new IllegalArgumentException("pod " + pod + ": thrust " + thrust + ", expected 0.." + GREATEST_THRUST
                + ", SHIELD, BOOST or NO_COMMAND");
        }
    }

    /** How many pods there are. */
    public int pods() {
        return thrust.length;
    }

    /** No command for any pod. */
    public void clear() {
        Arrays.fill(targetX, 0);
        Arrays.fill(targetY, 0);
        Arrays.fill(thrust, NO_COMMAND);
    }

    /**
     * Becomes a copy.
     *
     * @throws IllegalArgumentException if the numbers of pods differ
     */
    public void copyFrom(PodCommands other) {
        if (other.pods() != pods()) {
            throw new IllegalArgumentException("commands for " + other.pods() + " pods, expected " + pods());
        }
        System.arraycopy(other.targetX, 0, targetX, 0, targetX.length);
        System.arraycopy(other.targetY, 0, targetY, 0, targetY.length);
        System.arraycopy(other.thrust, 0, thrust, 0, thrust.length);
    }

    /** Where a pod is to steer, in u. */
    public double targetX(int pod) {
        return targetX[pod];
    }

    /** Where a pod is to steer, in u. */
    public double targetY(int pod) {
        return targetY[pod];
    }

    /** The thrust, {@link #SHIELD}, {@link #BOOST} or {@link #NO_COMMAND}. */
    public int thrust(int pod) {
        return thrust[pod];
    }
}
