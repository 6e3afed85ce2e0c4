package steward.game.podrace.simulator;

import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import steward.game.podrace.PodRace;
import steward.game.podrace.PodState;
import steward.game.podrace.Races;
import steward.numerics.SplitMix64;

/**
 * Random states and commands of four pods of every sort that a kernel could stumble over: races, brawls, heaps,
 * overlaps, exact touches, whole and fractional, far out, every kind of heading, target and command.
 */
final class RandomTurns {

    static final int PODS = 4;
    private static final double[] AXES = {0, Math.PI / 2, Math.PI, -Math.PI / 2, -Math.PI, Math.PI / 4, -0.0};

    final double[] x = new double[PODS];
    final double[] y = new double[PODS];
    final double[] vx = new double[PODS];
    final double[] vy = new double[PODS];
    final double[] heading = new double[PODS];
    final int[] timer = new int[PODS];
    final boolean[] boost = new boolean[PODS];
    final int[] passed = new int[PODS];
    final PodCommands commands = new PodCommands(PODS);

    private final SplitMix64 random;
    /** True if all pods turn to one side all the time: long chains of turns by 18 degrees. */
    private boolean spinning;

    RandomTurns(long seed) {
        random = new SplitMix64(seed);
    }

    /** How many turns the drawn state is played on: usually some, sometimes many. */
    int turns() {
        return spinning ? 60 : random.nextInt(1, 12);
    }

    /** A map of 2 to 6 checkpoints in the usual field. */
    double[][] map() {
        double[][] map = new double[random.nextInt(2, 6)][];
        for (int k = 0; k < map.length; k++) {
            map[k] = new double[] {random.nextInt(0, 16000), random.nextInt(0, 9000)};
        }
        map[1][0] = map[1][0] == map[0][0] ? map[0][0] + 1 : map[1][0];
        return map;
    }

    /** Draws new states. */
    void state() {
        int crowd = random.nextInt(10);
        spinning = random.nextInt(40) == 0;
        for (int pod = 0; pod < PODS; pod++) {
            place(pod, crowd);
            int speed = random.nextInt(20) == 0 ? 3000 : crowd == 3 ? 5 : 600;
            vx[pod] = random.nextInt(-speed, speed);
            vy[pod] = random.nextInt(-speed, speed);
            if (random.nextInt(20) == 0) {
                vx[pod] += random.nextDouble();
                vy[pod] -= random.nextDouble();
            }
            heading[pod] = heading();
            timer[pod] = random.nextInt(4) == 0 ? random.nextInt(0, 4) : 0;
            boost[pod] = random.nextInt(2) == 0;
            passed[pod] = random.nextInt(0, 15);
        }
        if (crowd == 6) {
            touchExactly();
        }
    }

    private void place(int pod, int crowd) {
        int width = crowd < 3 ? 16000 : crowd == 3 ? 10 : crowd < 6 ? 2400 : 5000;
        x[pod] = random.nextInt(0, width);
        y[pod] = random.nextInt(0, width * 9 / 16 + 1);
        if (crowd == 7) {
            double far = Math.scalb(1.0, random.nextInt(10, 40));
            x[pod] += Math.rint(far);
            y[pod] -= Math.rint(far);
        } else if (crowd == 8 && random.nextInt(4) == 0) {
            x[pod] += random.nextDouble();
            y[pod] += random.nextDouble();
        } else if (crowd == 9 && random.nextInt(3) == 0) {
            x[pod] = random.nextInt(-40000, 40000);
            y[pod] = random.nextInt(-40000, 40000);
        }
    }

    /** Exactly 800 apart along an axis or a Pythagorean direction, or one unit in the last place to either side. */
    private void touchExactly() {
        double[][] apart = {{800, 0}, {0, 800}, {480, 640}, {-640, 480}, {224, 768}};
        for (int pod = 1; pod < PODS; pod++) {
            double[] to = apart[random.nextInt(apart.length)];
            x[pod] = x[pod - 1] + to[0];
            y[pod] = y[pod - 1] + to[1];
            if (random.nextInt(3) == 0 && x[pod] != 0) {  // the least double has no square
                x[pod] = random.nextInt(2) == 0 ? Math.nextUp(x[pod]) : Math.nextDown(x[pod]);
            }
            if (random.nextInt(3) == 0) {
                vx[pod] = vx[pod - 1];
                vy[pod] = vy[pod - 1];
            }
        }
    }

    private double heading() {
        return switch (random.nextInt(10)) {
            case 0 -> Double.NaN;
            case 1 -> AXES[random.nextInt(AXES.length)];
            case 2 -> AXES[random.nextInt(AXES.length)] + random.nextInt(-40, 40) * (Math.PI / 10);
            case 3 -> Math.toRadians(random.nextInt(0, 360));
            case 4 -> (random.nextDouble() - 0.5) * Math.scalb(1.0, random.nextInt(0, 60));
            case 5 -> StrictMath.atan2(random.nextInt(-30, 30), random.nextInt(-30, 30));
            default -> (random.nextDouble() - 0.5) * 2 * Math.PI;
        };
    }

    /** Draws new commands for the pods of a simulator, whose headings stay deferred. */
    void commands(PodRaceSimulator race) {
        commands(numbers(race::x), numbers(race::y),
            numbers(pod -> Math.atan2(race.directionY(pod), race.directionX(pod))));
    }

    static double[] numbers(IntToDoubleFunction of) {
        return IntStream.range(0, PODS).mapToDouble(of).toArray();
    }

    /** Draws new commands for pods at these places with these headings. */
    void commands(double[] atX, double[] atY, double[] heads) {
        for (int pod = 0; pod < PODS; pod++) {
            double tx = random.nextInt(0, 16000);
            double ty = random.nextInt(0, 9000);
            switch (spinning ? 7 : random.nextInt(16)) {
                case 0 -> {                             // its own place
                    tx = atX[pod];
                    ty = atY[pod];
                }
                case 1 -> {
                    tx = (random.nextDouble() - 0.5) * Math.scalb(1.0, random.nextInt(-600, 600));
                    ty = (random.nextDouble() - 0.5) * Math.scalb(1.0, random.nextInt(-600, 600));
                }
                case 2 -> {
                    tx += random.nextDouble();
                    ty += random.nextDouble();
                }
                case 3 -> ty = atY[pod];
                case 4 -> tx = atX[pod];
                case 5 -> {                             // very nearly 18 degrees, or straight behind
                    double turn = random.nextInt(3) == 0 ? Math.PI : Math.PI / 10;
                    double angle = heads[pod] + (random.nextInt(2) == 0 ? turn : -turn)
                        * (1 + random.nextInt(-3, 3) * Math.scalb(1.0, -random.nextInt(20, 52)));
                    tx = atX[pod] + 10000 * StrictMath.cos(angle);
                    ty = atY[pod] + 10000 * StrictMath.sin(angle);
                }
                case 6 -> {
                    tx = atX[pod] + random.nextInt(-30, 30);
                    ty = atY[pod] + random.nextInt(-30, 30);
                }
                case 7 -> {                             // never reached
                    tx = atX[pod] + 10000 * StrictMath.cos(heads[pod] + 2);
                    ty = atY[pod] + 10000 * StrictMath.sin(heads[pod] + 2);
                }
                default -> { }
            }
            if (!(Math.abs(tx) < 1e300 && Math.abs(ty) < 1e300)) {
                tx = 0;
                ty = 0;
            }
            int thrust = switch (random.nextInt(12)) {
                case 0 -> PodCommands.NO_COMMAND;
                case 1, 2 -> PodCommands.SHIELD;
                case 3 -> PodCommands.BOOST;
                case 4 -> 0;
                default -> random.nextInt(0, 200);
            };
            commands.set(pod, tx, ty, thrust);
        }
    }

    private PodState state(int pod) {
        return new PodState(x[pod], y[pod], vx[pod], vy[pod], heading[pod], timer[pod], boost[pod], passed[pod]);
    }

    void put(PodRaceSimulator race) {
        for (int pod = 0; pod < PODS; pod++) {
            Races.put(race, pod, state(pod));
        }
    }

    void put(PodRace race) {
        for (int pod = 0; pod < PODS; pod++) {
            race.setPod(pod, state(pod));
        }
    }

    void put(TextbookPodRace race) {
        for (int pod = 0; pod < PODS; pod++) {
            Races.put(race, pod, state(pod));
            race.pod(pod).mass = timer[pod] == 4 ? 10 : 1;
        }
    }

    void play(TextbookPodRace race) {
        race.play(commands.targetX, commands.targetY, commands.thrust);
    }

    String text() {
        StringBuilder text = new StringBuilder();
        for (int k = 0; k < PODS; k++) {
            text.append('\n').append(k).append(": ").append(state(k)).append(" to ").append(commands.targetX(k))
                .append(' ').append(commands.targetY(k)).append(' ').append(commands.thrust(k));
        }
        return text.toString();
    }
}
