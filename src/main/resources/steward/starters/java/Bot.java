import java.util.Scanner;

/**
 * A starter bot for the pod race: copy it and make it better.
 *
 * <p>It speaks CodinGame's lines. At the start: laps, the number of checkpoints, and one line "x y" for each.
 * Every turn: four lines "x y vx vy angle nextCheckpoint", your two pods first, then the other player's.
 * Answer every turn with one line for each of your pods: "x y thrust", a place to steer at and 0 to 200;
 * in place of the thrust you can say SHIELD or BOOST (the boost works once). Use System.err for notes.
 */
public class Bot {

    static final int OWN = 2;
    static final int OTHERS = 2;
    /** How many turns of its own speed a pod takes into account when it aims. */
    static final int DRIFT_TURNS = 4;
    static final int FULL_THRUST = 200;

    record Place(int x, int y) { }

    record Pod(int x, int y, int vx, int vy, int angle, int next) {

        static Pod read(Scanner in) {
            return new Pod(in.nextInt(), in.nextInt(), in.nextInt(), in.nextInt(), in.nextInt(), in.nextInt());
        }

        String command(Place[] checkpoints) {
            // A pod keeps most of its speed from turn to turn. Aim beside the checkpoint, against that drift.
            int toX = checkpoints[next].x() - DRIFT_TURNS * vx;
            int toY = checkpoints[next].y() - DRIFT_TURNS * vy;
            // A pod can turn by only 18 degrees a turn: no thrust while it looks elsewhere (-1: looks nowhere yet).
            double wanted = Math.toDegrees(Math.atan2(toY - y, toX - x));
            double off = Math.IEEEremainder(wanted - angle, 360);       // -180..180, 0 is straight ahead
            int thrust = angle >= 0 && Math.abs(off) > 80 ? 0 : FULL_THRUST;
            return toX + " " + toY + " " + thrust;
        }
    }

    public static void main(String[] arguments) {
        Scanner in = new Scanner(System.in);
        int laps = in.nextInt();
        Place[] checkpoints = new Place[in.nextInt()];
        for (int k = 0; k < checkpoints.length; k++) {
            checkpoints[k] = new Place(in.nextInt(), in.nextInt());
        }
        Pod[] pods = new Pod[OWN + OTHERS];
        while (in.hasNextInt()) {                       // until the referee closes our input
            for (int k = 0; k < pods.length; k++) {
                pods[k] = Pod.read(in);
            }
            for (int k = 0; k < OWN; k++) {
                System.out.println(pods[k].command(checkpoints));
            }
            System.out.flush();                         // without it the referee could wait in vain
        }
    }
}
