import java.util.Scanner;
import steward.game.podrace.simulator.PodCommands;
import steward.game.podrace.simulator.PodRaceSimulator;

public class Searcher {
    public static void main(String[] arguments) {
        Scanner in = new Scanner(System.in);
        int laps = in.nextInt(), n = in.nextInt();
        double[][] places = new double[n][];
        for (int k = 0; k < n; k++) places[k] = new double[] {in.nextInt(), in.nextInt()};
        PodRaceSimulator now = new PodRaceSimulator(places, 2, 2, laps), trial = new PodRaceSimulator(places, 2, 2, laps);
        PodCommands commands = new PodCommands(4);
        int[] passed = new int[4];
        while (in.hasNextInt()) {
            for (int pod = 0; pod < 4; pod++) {                                        // own pods first
                int x = in.nextInt(), y = in.nextInt(), vx = in.nextInt(), vy = in.nextInt(), angle = in.nextInt();
                for (int next = in.nextInt(); (passed[pod] + 1) % n != next; passed[pod]++) { }
                now.setPod(pod, x, y, vx, vy, angle < 0 ? Double.NaN : Math.toRadians(angle), 0, false, passed[pod]);
            }
            for (int pod = 0; pod < 2; pod++) {
                String best = "", tried = "";
                double most = Double.NEGATIVE_INFINITY;
                for (int thrust = 0; thrust <= 200; thrust += 50) {
                    trial.copyFrom(now);
                    for (int turn = 0; turn < 6; turn++) {
                        for (int each = 0; each < 4; each++) {                         // all drive against their drift
                            double[] next = places[trial.nextCheckpoint(each)];
                            commands.set(each, Math.round(next[0] - 3 * trial.vx(each)),
                                Math.round(next[1] - 3 * trial.vy(each)), each == pod ? thrust : 100);
                        }
                        if (turn == 0) tried = (long) commands.targetX(pod) + " " + (long) commands.targetY(pod) + " " + thrust;
                        trial.play(commands);
                    }
                    double worth = 50_000 * trial.passed(pod) - trial.toNext(pod);
                    if (worth > most) best = tried;
                    most = Math.max(most, worth);
                }
                System.out.println(best);
            }
        }
    }
}
