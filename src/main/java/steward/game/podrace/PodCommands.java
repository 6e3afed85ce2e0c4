package steward.game.podrace;

import java.util.Arrays;

/** One command per pod, for a {@link PodRaceSimulator} or a {@link PodRaceBatch}: fill it, play it, fill it anew. */
public final class PodCommands {

    /** Instead of a thrust: no command, as of a player who is out. The pod drifts. */
    public static final int NO_COMMAND = PodRace.NO_COMMAND;
    /** Instead of a thrust: raise the shield. */
    public static final int SHIELD = PodRace.SHIELD;
    /** Instead of a thrust: boost. */
    public static final int BOOST = PodRace.BOOST;

    final double[] targetX;
    final double[] targetY;
    final int[] thrust;

    /** No command for any pod. */
    public PodCommands(int pods) {
        targetX = new double[pods];
        targetY = new double[pods];
        thrust = new int[pods];
        clear();
    }

    /**
     * @param x          where to steer, in u; finite
     * @param y          where to steer, in u; finite
     * @param podThrust  0..650 (a race asks for 0..200 at most), {@link #SHIELD}, {@link #BOOST} or {@link #NO_COMMAND}
     */
    public void set(int pod, double x, double y, int podThrust) {
        targetX[pod] = x;
        targetY[pod] = y;
        thrust[pod] = podThrust;
    }

    /** No command for any pod. */
    public void clear() {
        Arrays.fill(targetX, 0);
        Arrays.fill(targetY, 0);
        Arrays.fill(thrust, NO_COMMAND);
    }

    public void copyFrom(PodCommands other) {
        System.arraycopy(other.targetX, 0, targetX, 0, targetX.length);
        System.arraycopy(other.targetY, 0, targetY, 0, targetY.length);
        System.arraycopy(other.thrust, 0, thrust, 0, thrust.length);
    }

    public double targetX(int pod) {
        return targetX[pod];
    }

    public double targetY(int pod) {
        return targetY[pod];
    }

    public int thrust(int pod) {
        return thrust[pod];
    }
}
