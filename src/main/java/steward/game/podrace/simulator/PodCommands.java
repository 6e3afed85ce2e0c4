package steward.game.podrace.simulator;

import java.util.Arrays;
import steward.game.podrace.PodRace;
import steward.game.podrace.PodRaceSettings;

/**
 * One command per pod, for a {@link PodRaceSimulator}; reused from turn to turn. A command stays until another is set.
 * A pod steers towards its target, as in a bot's answer; if the target is its own position, it neither turns nor
 * thrusts.
 */
public final class PodCommands {

    /** Instead of a thrust: no command, as for an eliminated player. The pod drifts. */
    public static final int NO_COMMAND = PodRace.NO_COMMAND;
    /**
     * Instead of a thrust: raise the shield. Multiplies the mass by 10 for the turn; no thrust on this and the next
     * three turns.
     */
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
     * @param pods number of pods, at least 1
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
     * @param x         of the target, in u; finite
     * @param y         of the target, in u; finite
     * @param podThrust 0..{@link #GREATEST_THRUST}, {@link #SHIELD}, {@link #BOOST} or {@link #NO_COMMAND}
     * @throws IllegalArgumentException  if a number is out of range
     * @throws IndexOutOfBoundsException if there is no such pod
     */
    public void set(int pod, double x, double y, int podThrust) {
        check(pod, x, y, podThrust);
        targetX[pod] = x;
        targetY[pod] = y;
        thrust[pod] = podThrust;
    }

    /** Throws if a command is out of range. */
    static void check(int pod, double x, double y, int thrust) {
        if (!(Math.abs(x) <= Double.MAX_VALUE && Math.abs(y) <= Double.MAX_VALUE)) {
            throw new IllegalArgumentException("pod " + pod + ": target " + x + " " + y + ", expected finite numbers");
        }
        if (thrust < BOOST || thrust > GREATEST_THRUST) {
            throw new IllegalArgumentException("pod " + pod + ": thrust " + thrust + ", expected 0.." + GREATEST_THRUST
                + ", SHIELD, BOOST or NO_COMMAND");
        }
    }

    /** The number of pods. */
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
     * Copies other commands.
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

    /** The x coordinate of a pod's target, in u. */
    public double targetX(int pod) {
        return targetX[pod];
    }

    /** The y coordinate of a pod's target, in u. */
    public double targetY(int pod) {
        return targetY[pod];
    }

    /** The thrust, {@link #SHIELD}, {@link #BOOST} or {@link #NO_COMMAND}. */
    public int thrust(int pod) {
        return thrust[pod];
    }
}
