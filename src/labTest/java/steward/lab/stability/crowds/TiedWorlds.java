package steward.lab.stability.crowds;

import java.util.ArrayList;
import java.util.List;
import steward.lab.oracle.FirstInstant;
import steward.numerics.SplitMix64;
import steward.physics.Arena;
import steward.physics.Bodies;
import steward.physics.HalfPlane;
import steward.physics.Wall;

/*
 * Ties along Pythagorean triples: directions (a, b) of length 65. Turned by them, whole numbers stay whole.
 *
 *     hub      discs at m (a, b) fly to a disc at rest at the origin with -k m (a, b): all touch it after
 *              (1 - (R + r) / 65 m) / k turns. A disc hits a wall, and two discs meet, after the same time.
 *     turned   a disc at d with velocity v touches the disc at the origin after an irrational time, and so do those
 *              turned from it; two discs at g times its distance, velocity and size meet after the same time.
 *     arena    the same for a disc that flies from inside to the rim of an arena.
 */

/** Random worlds in which several impacts have exactly the same time, which is rarely a double. */
public final class TiedWorlds {

    private static final int[][] TURNS = {{33, 56}, {16, 63}, {25, 60}, {39, 52}, {65, 0}};
    private static final int LENGTH = 65;
    /** How far from the origin the second group of a world is. */
    private static final int APART = 4000;

    /**
     * A world before its turn.
     *
     * @param impacts those of its first instant by the rule, as {@link FirstInstant#impacts}
     */
    public record World(Bodies bodies, List<Wall> walls, List<String> impacts) { }

    private record Disc(long x, long y, long vx, long vy, long radius) {

        /** Turned by an angle whose sine and cosine are multiples of 1/65, and 65 times as far. */
        Disc turned(int[] by) {
            return new Disc(by[0] * x - by[1] * y, by[1] * x + by[0] * y, by[0] * vx - by[1] * vy,
                by[1] * vx + by[0] * vy, radius);
        }
    }

    private final SplitMix64 random;
    private final List<Disc> discs = new ArrayList<>();
    private final List<Wall> walls = new ArrayList<>();
    private int contacts;

    private TiedWorlds(SplitMix64 random) {
        this.random = random;
    }

    /** Draws a world; another one while its discs meet earlier, or an impact or none is not a clear decision. */
    public static World draw(SplitMix64 random) {
        for (;;) {
            TiedWorlds drawn = new TiedWorlds(random);
            switch (random.nextInt(3)) {
                case 0 -> drawn.hub();
                case 1 -> drawn.turned();
                default -> drawn.arena();
            }
            Bodies bodies = drawn.shuffled();
            FirstInstant first = new FirstInstant(bodies, drawn.walls);
            if (first.isClear() && first.contacts() == drawn.contacts) {
                return new World(bodies, List.copyOf(drawn.walls), first.impacts());
            }
        }
    }

    /** A few of the directions, each once. */
    private List<int[]> directions(int most) {
        List<int[]> all = new ArrayList<>();
        for (int[] turn : TURNS) {
            for (int k = 0; k < 4; k++) {
                int a = k % 2 == 0 ? turn[0] : -turn[1];
                int b = k % 2 == 0 ? turn[1] : turn[0];
                all.add(new int[] {k < 2 ? a : -a, k < 2 ? b : -b});
            }
        }
        List<int[]> drawn = new ArrayList<>();
        int count = random.nextInt(2, most + 1);
        for (int k = 0; k < count; k++) {
            drawn.add(all.remove(random.nextInt(all.size())));
        }
        return drawn;
    }

    private void hub() {
        int far = random.nextInt(1, 5);
        int speed = random.nextInt(1, 3);
        int radius = random.nextInt(2, 10);
        int touch = radius + random.nextInt(5, 30);
        add(0, 0, 0, 0, touch - radius);
        for (int[] to : directions(5)) {
            contacts++;
            add(far * to[0], far * to[1], -speed * far * to[0], -speed * far * to[1], radius);
        }
        other(LENGTH * far - touch, speed * LENGTH * far, random.nextInt(3));
    }

    /** @param kind 0 for nothing else, 1 for a disc that hits a wall, 2 for two discs that meet */
    private void other(long gap, long speed, int kind) {
        int g = random.nextInt(1, 4);
        if (kind == 1) {
            int radius = random.nextInt(1, 20);
            walls.add(new HalfPlane(-APART, 0, 1, 0, 1));
            contacts++;
            add(-APART + radius + g * gap, -APART, -g * speed, random.nextInt(7), radius);
        } else if (kind == 2) {
            int first = random.nextInt(1, 20);
            int second = random.nextInt(1, 20);
            int drift = random.nextInt(7);
            contacts++;
            add(APART, -APART, 0, drift, first);
            add(APART + first + second + g * gap, -APART, -g * speed, drift, second);
        }
    }

    private void turned() {
        int distance = random.nextInt(20, 60);
        int off = random.nextInt(-9, 10);
        Disc first = new Disc(distance, off, -distance - random.nextInt(distance), random.nextInt(-5, 6),
            random.nextInt(100, 600));
        int hub = random.nextInt(100, 900);
        add(0, 0, 0, 0, hub);
        for (int[] by : directions(4)) {
            contacts++;
            discs.add(first.turned(by));
        }
        if (random.nextInt(2) == 0) {
            int g = random.nextInt(2, 4);
            Disc along = first.turned(new int[] {LENGTH, 0});
            contacts++;
            add(20 * APART, 20 * APART, 0, 0, g * hub);
            add(20 * APART + g * along.x, 20 * APART + g * along.y, g * along.vx, g * along.vy, g * first.radius);
        }
    }

    private void arena() {
        int x = random.nextInt(3, 15);
        Disc first = new Disc(x, random.nextInt(-5, 6), random.nextInt(30, 60), random.nextInt(-25, 26),
            random.nextInt(20, 80));
        walls.add(new Arena(0, 0, random.nextInt(1500, 2000), 1));
        for (int[] by : directions(4)) {
            contacts++;
            discs.add(first.turned(by));
        }
    }

    private void add(long x, long y, long vx, long vy, long radius) {
        discs.add(new Disc(x, y, vx, vy, radius));
    }

    /** In any order, moved and adrift where there are no walls, and in any unit that is a power of two. */
    private Bodies shuffled() {
        int[] order = new int[discs.size()];
        for (int k = 0; k < order.length; k++) {
            int other = random.nextInt(k + 1);
            order[k] = order[other];
            order[other] = k;
        }
        boolean free = walls.isEmpty();
        long moveX = free ? random.nextInt(-5000, 5000) : 0;
        long driftX = free ? random.nextInt(-50, 50) : 0;
        long driftY = free ? random.nextInt(-50, 50) : 0;
        double unit = free ? Math.scalb(1.0, random.nextInt(-9, 9)) : 1;
        Bodies bodies = new Bodies(order.length);
        for (int k = 0; k < order.length; k++) {
            Disc disc = discs.get(order[k]);
            bodies.add(unit * (disc.x + moveX), unit * disc.y, unit * disc.radius, random.nextInt(1, 4));
            bodies.setVelocity(k, unit * (disc.vx + driftX), unit * (disc.vy + driftY));
        }
        return bodies;
    }
}
