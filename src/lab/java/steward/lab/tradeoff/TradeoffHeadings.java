package steward.lab.tradeoff;

import steward.lab.timing.WorkClock;
import steward.numerics.Median;
import steward.numerics.SineCosine;
import steward.numerics.SplitMix64;

/*
 * The official rule (published referee of the pod race): delta = (atan2(target - position) - heading) mod 2 pi, the
 * shortest such angle; the heading moves by at most pi / 10 towards it; the direction (cos, sin), each correctly
 * rounded and divided by its length, times the thrust is added to the speed; then the position moves by the speed, the
 * speed is cut toward zero after 15% of drag, the position is rounded.
 *
 * Without trigonometry the heading is a unit vector h and the wanted one d = (target - position) / |target - position|.
 * The turn is within pi / 10 when h.d >= cos(pi / 10), and then the heading is d; otherwise h is turned by the constant
 * rotation (cos(pi / 10), -+ sin(pi / 10)) to the side given by the sign of h x d.
 */

/**
 * Price of trigonometry, and its effect: free turns of a pod under the official rule with angles, compared with the
 * same turns with unit vectors. Written here from the definition; the game has its own.
 *
 * @param headings    which headings: random, or along the axes
 * @param podTurns    how many
 * @param differing   how many end with different integers (position or speed)
 * @param nanosAngles CPU of a pod's turn with StrictMath's atan2 and correctly rounded cos and sin, in ns
 * @param nanosVector CPU of a pod's turn with unit vectors, in ns
 */
public record TradeoffHeadings(String headings, long podTurns, long differing, double nanosAngles,
                               double nanosVector) {

    private static final long SEED = 4;
    private static final double MOST = Math.PI / 10;
    private static final double FULL = 2 * Math.PI;
    private static final double COS = StrictMath.cos(MOST);
    private static final double SIN = StrictMath.sin(MOST);
    private static final double KEEP = 1 - 0.15;
    private static final int BLOCK = 10_000;

    /** The names of the two kinds of headings. */
    public static final String RANDOM = "random";
    /** Heading and target along the axes. */
    public static final String AXIS = "axis-aligned";

    /** Numbers of a block of pods: the start, and the end by either way, four numbers each. */
    private static final class Block {

        private final double[] place = new double[2 * BLOCK];
        private final double[] speed = new double[2 * BLOCK];
        private final double[] angle = new double[BLOCK];
        private final double[] vector = new double[2 * BLOCK];
        private final double[] target = new double[2 * BLOCK];
        private final double[] thrust = new double[BLOCK];
        private final double[] byAngles = new double[4 * BLOCK];
        private final double[] byVector = new double[4 * BLOCK];
    }

    /** Returns how many steps of progress {@link #measure} makes. */
    public static int steps(int podTurns) {
        return (podTurns + BLOCK - 1) / BLOCK;
    }

    /**
     * Measures one kind of headings.
     *
     * @param aligned  whether headings and targets are along the axes
     * @param podTurns rounded up to whole blocks of 10,000
     * @param step     called after each block
     */
    public static TradeoffHeadings measure(boolean aligned, int podTurns, Runnable step) {
        SplitMix64 random = new SplitMix64(SEED);
        WorkClock clock = WorkClock.THREAD;
        Block block = new Block();
        int blocks = steps(podTurns);
        double[] angles = new double[blocks];
        double[] vectors = new double[blocks];
        long differing = 0;
        for (int n = 0; n < blocks; n++) {
            fill(block, random, aligned);
            long start = clock.nanos();
            withAngles(block);
            long middle = clock.nanos();
            withVectors(block);
            long end = clock.nanos();
            angles[n] = (double) (middle - start) / BLOCK;
            vectors[n] = (double) (end - middle) / BLOCK;
            for (int pod = 0; pod < BLOCK; pod++) {
                boolean same = true;
                for (int k = 4 * pod; k < 4 * pod + 4; k++) {
                    same &= block.byAngles[k] == block.byVector[k];
                }
                differing += same ? 0 : 1;
            }
            step.run();
        }
        return new TradeoffHeadings(aligned ? AXIS : RANDOM, (long) blocks * BLOCK, differing,
            Median.of(angles), Median.of(vectors));
    }

    /**
     * Along the axes straight ahead; otherwise half of the targets about ahead, so that some turns are below the limit.
     */
    private static void fill(Block block, SplitMix64 random, boolean aligned) {
        for (int pod = 0; pod < BLOCK; pod++) {
            int x = 2 * pod;
            int y = x + 1;
            block.place[x] = random.nextInt(16_000);
            block.place[y] = random.nextInt(9_000);
            block.speed[x] = random.nextInt(-600, 600);
            block.speed[y] = random.nextInt(-600, 600);
            block.thrust[pod] = random.nextInt(201);
            double way = 1000 + random.nextInt(8000);
            double angle = aligned ? (random.nextInt(4) - 1) * (Math.PI / 2) : Math.PI * (2 * random.nextDouble() - 1);
            double wanted = aligned ? angle
                : angle + (random.nextInt(2) == 0 ? 0.1 : 2) * Math.PI * (random.nextDouble() - 0.5);
            block.angle[pod] = angle;
            block.vector[x] = aligned ? Math.rint(StrictMath.cos(angle)) : StrictMath.cos(angle);
            block.vector[y] = aligned ? Math.rint(StrictMath.sin(angle)) : StrictMath.sin(angle);
            block.target[x] = block.place[x] + Math.rint(way * StrictMath.cos(wanted));
            block.target[y] = block.place[y] + Math.rint(way * StrictMath.sin(wanted));
        }
    }

    private static void withAngles(Block block) {
        SineCosine direction = new SineCosine();
        for (int pod = 0; pod < BLOCK; pod++) {
            int x = 2 * pod;
            int y = x + 1;
            double heading = block.angle[pod];
            double wanted = StrictMath.atan2(block.target[y] - block.place[y], block.target[x] - block.place[x]);
            double delta = (wanted - heading) % FULL;
            double shortest = 2 * delta % FULL - delta;
            heading = Math.abs(shortest) < MOST ? wanted : heading + (shortest > 0 ? MOST : -MOST);
            direction.turn(heading);
            double cos = direction.cos();
            double sin = direction.sin();
            double length = Math.sqrt(cos * cos + sin * sin);
            fly(block, pod, cos / length, sin / length, block.byAngles);
        }
    }

    private static void withVectors(Block block) {
        for (int pod = 0; pod < BLOCK; pod++) {
            int x = 2 * pod;
            int y = x + 1;
            double dx = block.target[x] - block.place[x];
            double dy = block.target[y] - block.place[y];
            double length = Math.sqrt(dx * dx + dy * dy);
            dx /= length;
            dy /= length;
            double hx = block.vector[x];
            double hy = block.vector[y];
            if (hx * dx + hy * dy < COS) {
                double sin = hx * dy - hy * dx > 0 ? SIN : -SIN;
                dx = hx * COS - hy * sin;
                dy = hy * COS + hx * sin;
            }
            fly(block, pod, dx, dy, block.byVector);
        }
    }

    private static void fly(Block block, int pod, double dx, double dy, double[] end) {
        double vx = block.speed[2 * pod] + dx * block.thrust[pod];
        double vy = block.speed[2 * pod + 1] + dy * block.thrust[pod];
        end[4 * pod] = Math.floor(block.place[2 * pod] + vx + 0.5);
        end[4 * pod + 1] = Math.floor(block.place[2 * pod + 1] + vy + 0.5);
        end[4 * pod + 2] = cut(vx * KEEP);
        end[4 * pod + 3] = cut(vy * KEEP);
    }

    private static double cut(double value) {
        return value < 0 ? Math.ceil(value) : Math.floor(value);
    }
}
