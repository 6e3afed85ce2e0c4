package steward.bots;

import java.util.Arrays;

/** One command per pod: where to steer and with how much thrust, or the shield or the boost. */
final class Commands {

    /** Pseudo-thrust: raise the shield. */
    static final int SHIELD = -1;
    /** Pseudo-thrust: boost. */
    static final int BOOST = -2;

    /** How far away the target for a direction is set, in u. */
    private static final double FAR = 10000;

    double[] targetX = new double[8];
    double[] targetY = new double[8];
    /** 0..200, {@link #SHIELD} or {@link #BOOST}. */
    int[] thrust = new int[8];

    private final StringBuilder line = new StringBuilder(256);

    void set(int pod, double x, double y, int podThrust) {
        if (pod >= thrust.length) {
            int capacity = 2 * pod;
            targetX = Arrays.copyOf(targetX, capacity);
            targetY = Arrays.copyOf(targetY, capacity);
            thrust = Arrays.copyOf(thrust, capacity);
        }
        targetX[pod] = x;
        targetY[pod] = y;
        thrust[pod] = podThrust;
    }

    /** Turns a pod from its heading by the angle that has this cosine and sine. */
    void turn(Pods pods, int pod, double cosine, double sine, int podThrust) {
        double hx = pods.headingX[pod];
        double hy = pods.headingY[pod];
        set(pod, pods.x[pod] + FAR * (hx * cosine - hy * sine), pods.y[pod] + FAR * (hx * sine + hy * cosine),
            podThrust);
    }

    /** The answer for a player's pods, targets in whole units, without line end; valid until the next call. */
    StringBuilder answer(Pods pods, int player) {
        line.setLength(0);
        line.append("{\"pods\":[");
        char separator = 0;
        for (int pod = 0; pod < pods.size; pod++) {
            if (pods.player[pod] == player) {
                if (separator != 0) {
                    line.append(separator);
                }
                separator = ',';
                append(pod);
            }
        }
        return line.append("]}");
    }

    private void append(int pod) {
        line.append("{\"x\":").append(Math.round(targetX[pod])).append(",\"y\":").append(Math.round(targetY[pod]));
        switch (thrust[pod]) {
            case SHIELD -> line.append(",\"shield\":true}");
            case BOOST -> line.append(",\"boost\":true}");
            default -> line.append(",\"thrust\":").append(thrust[pod]).append('}');
        }
    }
}
