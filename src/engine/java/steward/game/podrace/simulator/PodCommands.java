package steward.game.podrace.simulator;

import java.util.Arrays;
import steward.game.podrace.PodRace;
import steward.game.podrace.PodRaceSettings;

/**
 * Reusable buffer with one command per pod for a {@link PodRaceSimulator}. A command stays until another is set. A pod
 * steers towards its target, as in a bot's answer ({@link #set}), or turns by an angle ({@link #turn}). If the target
 * is its own position, it neither turns nor thrusts.
 *
 * <p>A search that turns its pods as far as they can should use {@link #turn}: a target just 18 degrees aside leaves it
 * to the last digits whether the pod reaches that direction, and the exact heading has to be computed each time.
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

    /** The greatest turn to either side, in degrees. */
    public static final double GREATEST_TURN = 18;

    /** The x coordinate of the target; or, of a command by angle, the degrees. */
    final double[] targetX;
    /** The y coordinate of the target; or, of a command by angle, NaN. */
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
        if (!(Math.abs(x) <= Double.MAX_VALUE && Math.abs(y) <= Double.MAX_VALUE)) {
            throw new IllegalArgumentException("pod " + pod + ": target " + x + " " + y + ", expected finite numbers");
        }
        checkThrust(pod, podThrust);
        targetX[pod] = x;
        targetY[pod] = y;
        thrust[pod] = podThrust;
    }

    /**
     * Turns a pod relative to its present heading. From 18 degrees on the heading moves by the double pi / 10, which is
     * what every target does that is farther aside. Below, it becomes heading + {@code Math.toRadians(degrees)}, one
     * addition of doubles: a target in just that direction gives the same up to the rounding of its arc tangent, and
     * of whole turns. 0 leaves the heading as it is. A pod whose heading is unset neither turns nor thrusts, as if its
     * target were its own position: set a target for its first turn.
     *
     * <p>{@link PodRaceSimulator#targetX(int, double)} finds a target that makes a real race do the same.
     *
     * <p>Turns by 18, 0 and -18 degrees need no angle, those between need its sine and cosine.
     *
     * @param degrees   positive from the x axis to the y axis: clockwise as seen on a screen; more than 18 to either
     *                  side count as 18
     * @param podThrust as for {@link #set}
     * @throws IllegalArgumentException  if the degrees are NaN or the thrust is out of range
     * @throws IndexOutOfBoundsException if there is no such pod
     */
    public void turn(int pod, double degrees, int podThrust) {
        if (Double.isNaN(degrees)) {
            throw new IllegalArgumentException("pod " + pod + ": turn by NaN degrees, expected a number");
        }
        checkThrust(pod, podThrust);
        targetX[pod] = limited(degrees);
        targetY[pod] = Double.NaN;
        thrust[pod] = podThrust;
    }

    /** The degrees that a pod turns at most when told to turn by these. */
    static double limited(double degrees) {
        return Math.max(-GREATEST_TURN, Math.min(GREATEST_TURN, degrees));
    }

    private static void checkThrust(int pod, int thrust) {
        if (thrust < BOOST || thrust > GREATEST_THRUST) {
            throw new IllegalArgumentException("pod " + pod + ": thrust " + thrust + ", expected 0.." + GREATEST_THRUST
                + ", SHIELD, BOOST or NO_COMMAND");
        }
    }

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

    /** The x coordinate of a pod's target, in u; NaN of a command by angle. */
    public double targetX(int pod) {
        return Double.isNaN(targetY[pod]) ? Double.NaN : targetX[pod];
    }

    /** The degrees of a command by angle, -18..18; NaN of a command by target. */
    public double degrees(int pod) {
        return Double.isNaN(targetY[pod]) ? targetX[pod] : Double.NaN;
    }

    /** The y coordinate of a pod's target, in u; NaN of a command by angle. */
    public double targetY(int pod) {
        return targetY[pod];
    }

    /** The thrust, {@link #SHIELD}, {@link #BOOST} or {@link #NO_COMMAND}. */
    public int thrust(int pod) {
        return thrust[pod];
    }
}
