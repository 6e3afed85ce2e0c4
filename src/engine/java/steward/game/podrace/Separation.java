package steward.game.podrace;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import steward.physics.Arena;
import steward.physics.Segment;
import steward.physics.Wall;
import steward.scene.Bumper;
import steward.scene.Field;

/**
 * Test for walls and bumpers that part two places, for the centre of a pod: each obstacle is grown by the pod's radius.
 */
final class Separation {

    /*
     * Two free places p and q are in different components of the free space if and only if a closed curve in the union
     * of the grown obstacles winds a different number of times around p than around q. Grown bumpers and segments are
     * convex; half-planes and the outsides of arenas meet at infinity, where they are one node. Obstacles are simply
     * connected, and so is where two of them meet; so all closed curves are made of those that go from obstacle to
     * obstacle through the places where two meet (nerve lemma). Each such passage is a polyline in the union here, and
     * a curve's difference of winding numbers is the sum of its signed crossings of the segment from p to q. So p and q
     * are parted if and only if the crossings are no difference of a potential: a union-find with weights finds out.
     */

    /** More passages than this are not looked at. */
    private static final int MOST_PASSAGES = 50_000;
    private static final int OUTSIDE = 0;
    /** Places of a passage: the anchor of one obstacle, where it meets the other, and the anchor of that. */
    private static final int POINTS = 4;

    /** A grown bumper or segment: all places up to a radius from a segment; for a bumper its ends are one. */
    private record Capsule(double ax, double ay, double bx, double by, double radius) { }

    private final List<Capsule> capsules = new ArrayList<>();
    private final List<Wall> outer = new ArrayList<>();
    private final double grown;
    /** {@code [passage][x, y, x, y, ...]}. */
    private double[][] passages = new double[16][];
    private int[] from = new int[16];
    private int[] to = new int[16];
    private int count;
    private final int[] parent;
    private final int[] potential;

    /** @param grown by how much obstacles are, in u */
    Separation(Field field, double grown) {
        this.grown = grown;
        for (Bumper bumper : field.bumpers()) {
            add(bumper.x(), bumper.y(), bumper.x(), bumper.y(), bumper.radius() + grown);
        }
        for (Wall wall : field.walls()) {
            if (wall instanceof Segment segment) {
                add(segment.ax(), segment.ay(), segment.bx(), segment.by(), grown);
            } else {
                outer.add(wall);
            }
        }
        for (int i = 0; i < capsules.size() && count <= MOST_PASSAGES; i++) {
            outwards(i);
            for (int j = 0; j < i && count <= MOST_PASSAGES; j++) {
                between(i, j);
            }
        }
        if (count > MOST_PASSAGES) {
            count = 0;
        }
        parent = new int[capsules.size() + 1];
        potential = new int[capsules.size() + 1];
        dropDeadEnds();
    }

    private void add(double ax, double ay, double bx, double by, double radius) {
        if (radius > 0) {
            capsules.add(new Capsule(ax, ay, bx, by, radius));
        }
    }

    /** Returns how many steps a question takes; 0 if no two places are parted. */
    int size() {
        return count;
    }

    private void between(int i, int j) {
        Capsule a = capsules.get(i);
        Capsule b = capsules.get(j);
        double reach = a.radius + b.radius + length(a) + length(b);
        double dx = b.ax - a.ax;
        double dy = b.ay - a.ay;
        if (dx * dx + dy * dy > reach * reach) {
            return;
        }
        double[] line = nearest(a, b);
        if (gap(line) < a.radius + b.radius) {
            passage(i + 1, j + 1, line);
        }
    }

    private static double length(Capsule capsule) {
        double dx = capsule.bx - capsule.ax;
        double dy = capsule.by - capsule.ay;
        return Math.sqrt(dx * dx + dy * dy);
    }

    /** The way between two anchors, with the places where the segments are nearest to each other in the middle. */
    private static double[] nearest(Capsule a, Capsule b) {
        double ux = a.bx - a.ax;
        double uy = a.by - a.ay;
        double vx = b.bx - b.ax;
        double vy = b.by - b.ay;
        double cross = ux * vy - uy * vx;
        if (cross != 0) {
            double s = ((b.ax - a.ax) * vy - (b.ay - a.ay) * vx) / cross;
            double t = ((b.ax - a.ax) * uy - (b.ay - a.ay) * ux) / cross;
            if (s >= 0 && s <= 1 && t >= 0 && t <= 1) {
                return line(a, s, b, t);
            }
        }
        double[][] lines = {line(a, share(a, b.ax, b.ay), b, 0), line(a, share(a, b.bx, b.by), b, 1),
            line(a, 0, b, share(b, a.ax, a.ay)), line(a, 1, b, share(b, a.bx, a.by))};
        double[] best = lines[0];
        for (double[] line : lines) {
            if (gap(line) < gap(best)) {
                best = line;
            }
        }
        return best;
    }

    private static double gap(double[] line) {
        double dx = line[2] - line[4];
        double dy = line[3] - line[5];
        return Math.sqrt(dx * dx + dy * dy);
    }

    private static double[] line(Capsule a, double s, Capsule b, double t) {
        return new double[] {a.ax, a.ay, a.ax + s * (a.bx - a.ax), a.ay + s * (a.by - a.ay),
            b.ax + t * (b.bx - b.ax), b.ay + t * (b.by - b.ay), b.ax, b.ay};
    }

    /** Returns where on the segment the nearest place is: 0 at a, 1 at b. */
    private static double share(Capsule capsule, double x, double y) {
        double dx = capsule.bx - capsule.ax;
        double dy = capsule.by - capsule.ay;
        double square = dx * dx + dy * dy;
        return square == 0 ? 0
            : Math.min(1, Math.max(0, ((x - capsule.ax) * dx + (y - capsule.ay) * dy) / square));
    }

    private void outwards(int i) {
        Capsule capsule = capsules.get(i);
        boolean single = capsule.ax == capsule.bx && capsule.ay == capsule.by;
        for (Wall wall : outer) {
            boolean both = wall instanceof Arena && !single;
            double first = wall.gap(capsule.ax, capsule.ay, grown + capsule.radius);
            double second = wall.gap(capsule.bx, capsule.by, grown + capsule.radius);
            if (first < 0 && (both || first <= second)) {
                outwards(i, wall, capsule.ax, capsule.ay);
            }
            if (second < 0 && (both || second < first)) {
                outwards(i, wall, capsule.bx, capsule.by);
            }
        }
    }

    /** From one end of a capsule as far towards a wall as the capsule reaches. */
    private void outwards(int i, Wall wall, double x, double y) {
        Capsule capsule = capsules.get(i);
        double outX = x + wall.normalX(x, y) * capsule.radius;
        double outY = y + wall.normalY(x, y) * capsule.radius;
        passage(i + 1, OUTSIDE, new double[] {capsule.ax, capsule.ay, x, y, outX, outY, outX, outY});
    }

    private void passage(int first, int second, double[] line) {
        if (count == passages.length) {
            passages = Arrays.copyOf(passages, 2 * count);
            from = Arrays.copyOf(from, 2 * count);
            to = Arrays.copyOf(to, 2 * count);
        }
        passages[count] = line;
        from[count] = first;
        to[count++] = second;
    }

    /** Passages that are on no closed curve: one end is an obstacle with no other passage. */
    private void dropDeadEnds() {
        int before;
        do {
            before = count;
            int[] degree = new int[capsules.size() + 1];
            for (int k = 0; k < before; k++) {
                degree[from[k]]++;
                degree[to[k]]++;
            }
            count = 0;
            for (int k = 0; k < before; k++) {
                if (degree[from[k]] > 1 && degree[to[k]] > 1) {
                    passages[count] = passages[k];
                    from[count] = from[k];
                    to[count++] = to[k];
                }
            }
        } while (count < before);
    }

    /** True if the places are parted; both must be free. */
    boolean parts(double px, double py, double qx, double qy) {
        for (int k = 0; k < parent.length; k++) {
            parent[k] = k;
            potential[k] = 0;
        }
        for (int k = 0; k < count; k++) {
            int crossings = crossings(passages[k], px, py, qx, qy);
            int a = root(from[k]);
            int b = root(to[k]);
            int apart = potential[from[k]] + crossings - potential[to[k]];
            if (a != b) {
                parent[b] = a;
                potential[b] = apart;
            } else if (apart != 0) {
                return true;
            }
        }
        return false;
    }

    /** The root of an obstacle's tree; afterwards its potential is the one against the root. */
    private int root(int node) {
        int root = node;
        int sum = 0;
        while (parent[root] != root) {
            sum += potential[root];
            root = parent[root];
        }
        for (int k = node; parent[k] != root && k != root;) {
            int next = parent[k];
            int own = potential[k];
            parent[k] = root;
            potential[k] = sum;
            sum -= own;
            k = next;
        }
        return root;
    }

    /**
     * Returns how often a polyline crosses the segment from p to q from right to left, less how often from left to
     * right.
     */
    private static int crossings(double[] line, double px, double py, double qx, double qy) {
        int sum = 0;
        for (int k = 0; k < POINTS - 1; k++) {
            double ux = line[2 * k];
            double uy = line[2 * k + 1];
            double vx = line[2 * k + 2];
            double vy = line[2 * k + 3];
            boolean left = (qx - px) * (uy - py) - (qy - py) * (ux - px) >= 0;
            boolean leftAfter = (qx - px) * (vy - py) - (qy - py) * (vx - px) >= 0;
            if (left != leftAfter) {
                boolean p = (vx - ux) * (py - uy) - (vy - uy) * (px - ux) >= 0;
                boolean q = (vx - ux) * (qy - uy) - (vy - uy) * (qx - ux) >= 0;
                sum += p == q ? 0 : leftAfter ? 1 : -1;
            }
        }
        return sum;
    }
}
