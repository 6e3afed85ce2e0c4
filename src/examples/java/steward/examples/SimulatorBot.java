package steward.examples;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.StringTokenizer;
import steward.game.podrace.simulator.PodCommands;
import steward.game.podrace.simulator.PodRaceSimulator;

/**
 * An example: a bot that searches with {@link PodRaceSimulator}. It uses CodinGame's text protocol and is a single
 * file:
 *
 * <pre>
 * javac -d build/bot -cp 'build/install/steward/lib/*' src/examples/java/steward/examples/SimulatorBot.java
 * steward match --bot builtin:racer --seed 7 \
 *     --bot "search=codingame:java -cp 'build/bot:build/install/steward/lib/*' steward.examples.SimulatorBot"
 * </pre>
 *
 * <p>(Java would also compile the file itself at each start, but that takes most of the second that a first answer
 * has.)
 *
 * <p>Each turn it tries, for each of its pods, five steering angles with and without thrust and the shield, held for
 * two turns and then followed by a simple driver; all other pods are predicted with that driver. The best first move is
 * played. 16 sequences of 8 turns for each pod, always the same for the same input: no clock, no randomness.
 */
public final class SimulatorBot {

    private static final int PODS = 4;
    private static final int OWN = 2;
    private static final int TURNS = 8;
    private static final int HELD_TURNS = 2;
    private static final double[] DEGREES = {-18, -9, 0, 9, 18};
    private static final int[] THRUSTS = {200, 80, PodCommands.SHIELD};
    private static final double CHECKPOINT_WORTH = 50_000;
    private static final double FAR = 10_000;

    private final PodRaceSimulator now;
    private final PodRaceSimulator trial;
    private final PodCommands commands = new PodCommands(PODS);
    private final PodCommands best = new PodCommands(PODS);
    private final int checkpoints;
    private final int[] passed = new int[PODS];
    private final int[] next = new int[PODS];
    private final int[] timer = new int[PODS];
    private int turn;

    /** @param places the checkpoints, {@code [n][x, y]} */
    public SimulatorBot(int laps, double[][] places) {
        now = new PodRaceSimulator(places, 2, OWN, laps);
        trial = new PodRaceSimulator(places, 2, OWN, laps);
        checkpoints = places.length;
        Arrays.fill(next, 1 % checkpoints);
    }

    /** Plays one match over the standard streams. */
    public static void main(String[] arguments) throws IOException {
        BufferedReader in = new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
        PrintStream out = new PrintStream(System.out, false, StandardCharsets.UTF_8);
        int laps = Integer.parseInt(in.readLine().strip());
        double[][] places = new double[Integer.parseInt(in.readLine().strip())][];
        for (int k = 0; k < places.length; k++) {
            StringTokenizer words = new StringTokenizer(in.readLine());
            places[k] = new double[] {Double.parseDouble(words.nextToken()), Double.parseDouble(words.nextToken())};
        }
        SimulatorBot bot = new SimulatorBot(laps, places);
        String[] lines = new String[PODS];
        for (;;) {
            for (int pod = 0; pod < PODS; pod++) {
                lines[pod] = in.readLine();
                if (lines[pod] == null) {
                    return;
                }
            }
            out.print(bot.answer(lines));
            out.flush();
        }
    }

    /** One turn: the lines {@code x y vx vy angle nextCheckPointId} of the pods, own ones first; two lines back. */
    public String answer(String[] lines) {
        turn++;
        for (int pod = 0; pod < PODS; pod++) {
            look(pod, new StringTokenizer(lines[pod]));
        }
        for (int pod = 0; pod < PODS; pod++) {
            drive(now, pod, best);
        }
        for (int pod = 0; pod < OWN; pod++) {
            search(pod);
        }
        StringBuilder answer = new StringBuilder();
        for (int pod = 0; pod < OWN; pod++) {
            boolean shield = best.thrust(pod) == PodCommands.SHIELD;
            timer[pod] = shield ? 4 : Math.max(0, timer[pod] - 1);
            answer.append(Math.round(best.targetX(pod))).append(' ').append(Math.round(best.targetY(pod))).append(' ')
                .append(shield ? "SHIELD" : Integer.toString(best.thrust(pod))).append('\n');
        }
        return answer.toString();
    }

    private void look(int pod, StringTokenizer words) {
        double x = Double.parseDouble(words.nextToken());
        double y = Double.parseDouble(words.nextToken());
        double vx = Double.parseDouble(words.nextToken());
        double vy = Double.parseDouble(words.nextToken());
        int angle = Integer.parseInt(words.nextToken());
        int seen = Integer.parseInt(words.nextToken());
        passed[pod] += (seen - next[pod] + checkpoints) % checkpoints;
        next[pod] = seen;
        double heading = angle < 0 ? Double.NaN : Math.toRadians(angle);
        now.setPod(pod, x, y, vx, vy, heading, pod < OWN ? timer[pod] : 0, false, passed[pod]);
    }

    /** Towards the next checkpoint, less three turns of the speed; slowly when it is behind the pod. */
    private static void drive(PodRaceSimulator race, int pod, PodCommands to) {
        int checkpoint = race.nextCheckpoint(pod);
        double x = race.checkpointX(checkpoint) - 3 * race.vx(pod);
        double y = race.checkpointY(checkpoint) - 3 * race.vy(pod);
        double ahead = race.directionX(pod) * (x - race.x(pod)) + race.directionY(pod) * (y - race.y(pod));
        to.set(pod, x, y, ahead < 0 ? 40 : 200);
    }

    private void search(int pod) {
        double most = worthOf(pod, Double.NaN, 0);
        for (int thrust : THRUSTS) {
            if (turn == 1 || thrust == PodCommands.SHIELD && timer[pod] > 0) {
                continue;                             // no heading yet; or a shield that would only be renewed
            }
            for (double degrees : DEGREES) {
                double x = now.x(pod) + FAR * turned(pod, degrees, true);
                double y = now.y(pod) + FAR * turned(pod, degrees, false);
                double worth = worthOf(pod, degrees, thrust);
                if (worth > most) {
                    most = worth;
                    best.set(pod, x, y, thrust);
                }
            }
        }
    }

    private double turned(int pod, double degrees, boolean wantX) {
        double cos = Math.cos(Math.toRadians(degrees));
        double sin = Math.sin(Math.toRadians(degrees));
        double x = now.directionX(pod);
        double y = now.directionY(pod);
        return wantX ? x * cos - y * sin : x * sin + y * cos;
    }

    /** Plays a sequence: a move held for some turns (or, with NaN, none), then the driver. */
    private double worthOf(int pod, double degrees, int thrust) {
        trial.copyFrom(now);
        for (int ahead = 0; ahead < TURNS; ahead++) {
            for (int each = 0; each < PODS; each++) {
                drive(trial, each, commands);
            }
            if (!Double.isNaN(degrees) && ahead < HELD_TURNS) {
                commands.set(pod, now.x(pod) + FAR * turned(pod, degrees, true),
                    now.y(pod) + FAR * turned(pod, degrees, false), thrust);
            }
            trial.play(commands);
        }
        return CHECKPOINT_WORTH * trial.passed(pod) - trial.toNext(pod);
    }
}
