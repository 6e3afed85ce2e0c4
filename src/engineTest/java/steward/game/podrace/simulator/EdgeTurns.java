package steward.game.podrace.simulator;

import steward.game.podrace.PodRace;
import steward.game.podrace.PodState;
import steward.numerics.SplitMix64;

/**
 * States and commands of any number of pods, put together from numbers at which something changes its way: ends of
 * ranges, halves, numbers whose drag or sum is whole, exact touches, tiny and huge numbers, angles beyond all vectors,
 * targets at a pod's own place, straight behind it, or 18 degrees aside.
 */
final class EdgeTurns {

    private static final double SMALL = 0x1p15;
    private static final double[][] APART = {{800, 0}, {0, 800}, {480, 640}, {-640, 480}, {224, 768}, {-800, 0},
        {0, 0}, {799.9999999999999, 0}, {0, 800.0000000000001}, {801, 0}, {400, -300}, {1, 0}, {1e-9, 0}};
    private static final double[] FIRST = {0, 0.5, -0.5, 0.49999999999999994, 7999.5, SMALL, -SMALL, SMALL - 0.5,
        Math.nextDown(SMALL), Math.nextUp(-SMALL), SMALL - 800, 2 * SMALL, 1e6, 1e9};
    private static final double[] STRANGE = {1e-320, 1e-100, 0x1p-200, 0x1p-201, 4503599627370495.5, 0x1p53, 1e20, 1e59,
        -1e-65};
    private static final double[] SPEEDS = {0, 0, 1, -1, 0.5, 20, 100, -300, 600, 800, -800, 1600, 0.85, 1.7, SMALL,
        -SMALL, Math.nextDown(SMALL), 1e5, -1e-17};
    private static final double[] STRANGE_SPEEDS = {Double.MIN_VALUE, -1e-300, 0x1p-700, 0x1p-701, 1e-250, 1e20, -1e58,
        2147483647, 3e9};
    private static final double[] HEADINGS = {Double.NaN, 0, -0.0, Math.PI / 2, -Math.PI / 2, Math.PI, -Math.PI,
        Math.PI / 4, Math.PI / 10, 1e-300, Double.MIN_VALUE, 511.99999, Math.nextDown(512), 512, -512, 1e3, 1e5, 1e22,
        1e300, -1e300};
    private static final int[] THRUSTS = {PodCommands.NO_COMMAND, PodCommands.SHIELD, PodCommands.BOOST, 0, 1, 2, 17,
        34, 100, 120, 199, 200};

    final double[] x;
    final double[] y;
    final double[] vx;
    final double[] vy;
    final double[] heading;
    final int[] timer;
    final PodCommands commands;

    private final int pods;
    private final SplitMix64 random;

    EdgeTurns(long seed, int pods) {
        random = new SplitMix64(seed);
        this.pods = pods;
        x = new double[pods];
        y = new double[pods];
        vx = new double[pods];
        vy = new double[pods];
        heading = new double[pods];
        timer = new int[pods];
        commands = new PodCommands(pods);
    }

    private double any(double[] of) {
        return of[random.nextInt(of.length)];
    }

    private boolean one(int in) {
        return random.nextInt(in) == 0;
    }

    /** One unit in the last place up or down, or neither. */
    private double shaken(double value) {
        return switch (random.nextInt(6)) {
            case 0 -> Math.nextUp(value);
            case 1 -> Math.nextDown(value);
            default -> value;
        };
    }

    /** Draws new states: heaps and rows around one place, or pods here and there. */
    void state() {
        boolean strange = one(6);
        boolean resting = one(4);
        boolean apart = one(3);
        for (int pod = 0; pod < pods; pod++) {
            if (pod == 0 || apart) {
                x[pod] = any(FIRST) + (apart ? 1200 * pod : 0);
                y[pod] = any(FIRST);
            } else {
                int beside = one(3) ? random.nextInt(pod) : pod - 1;
                double[] to = APART[random.nextInt(APART.length)];
                x[pod] = x[beside] + to[0];
                y[pod] = y[beside] + to[1];
            }
            if (one(5)) {
                x[pod] = ordinary(shaken(x[pod]));
                y[pod] = ordinary(shaken(y[pod]));
            }
            if (strange && one(2)) {
                x[pod] += one(2) ? any(STRANGE) : 0;
                y[pod] = one(2) ? any(STRANGE) : y[pod];
            }
            vx[pod] = resting ? 0 : speed(strange);
            vy[pod] = resting ? 0 : speed(strange);
            heading[pod] = one(2) ? any(HEADINGS) : any(HEADINGS) + random.nextInt(-60, 60) * (Math.PI / 10);
            timer[pod] = one(3) ? random.nextInt(0, 4) : 0;
        }
    }

    /** Without the unit in the last place of 0, which is {@link #STRANGE} enough. */
    private static double ordinary(double value) {
        return Math.abs(value) < 1e-300 ? 0 : value;
    }

    private double speed(boolean strange) {
        if (strange && one(3)) {
            return any(STRANGE_SPEEDS);
        }
        return switch (random.nextInt(4)) {
            case 0 -> ordinary(shaken(random.nextInt(-2000, 2000) / 0.85));
            case 1 -> random.nextInt(-1200, 1200) / 2.0;
            default -> any(SPEEDS);
        };
    }

    /** Draws new commands for pods in these states. */
    void draw(PodRace race) {
        for (int pod = 0; pod < pods; pod++) {
            PodState now = race.pod(pod);
            double far = Math.scalb(1.0, random.nextInt(0, 20));
            double tx = now.x();
            double ty = now.y();
            switch (random.nextInt(9)) {
                case 0 -> { }
                case 1 -> {
                    tx += far;
                    ty += one(2) ? 0 : far;
                }
                case 2 -> {
                    tx -= far;
                    ty = shaken(ty);
                }
                case 3 -> {
                    tx = 1e300;
                    ty = one(2) ? 1e-300 : -1e300;
                }
                case 4 -> {
                    tx = one(2) ? Double.MIN_VALUE : 1e30;
                    ty = one(2) ? 1e-200 : 1e154;
                }
                case 5 -> {                             // a thrust along a Pythagorean direction
                    tx += 3 * far;
                    ty -= 4 * far;
                }
                default -> {
                    double turn = one(2) ? Math.PI / 10 : one(2) ? Math.PI : 3;
                    double angle = (Double.isNaN(now.heading()) ? 0 : now.heading()) + (one(2) ? turn : -turn);
                    tx += 1000 * far * StrictMath.cos(angle);
                    ty += 1000 * far * StrictMath.sin(angle);
                }
            }
            commands.set(pod, tx, ty, THRUSTS[random.nextInt(THRUSTS.length)]);
        }
    }

    /** How many turns a state is played on: now and then so many that chains of turns by 18 degrees end. */
    int turns() {
        return one(30) ? 90 : random.nextInt(1, 4);
    }
}
