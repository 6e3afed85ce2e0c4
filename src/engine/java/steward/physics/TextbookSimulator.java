package steward.physics;

import java.util.Arrays;
import java.util.PriorityQueue;

/**
 * Simulator of elastic discs in a square box as in a textbook: predict all impacts, queue them by time, and bounce. An
 * event is dropped when it is due if one of its discs has had another impact since (R. Sedgewick, K. Wayne,
 * "Algorithms", 4th edition, section 6.1). It is the way into this package and the baseline of benchmarks, and used by
 * nothing else. It shares nothing with the other forms but the list of bodies that it starts from.
 */
public final class TextbookSimulator {

    /** Told of an impact with its time and two bodies; -1 in place of a for a horizontal wall, of b for a vertical. */
    public interface Listener {

        void impact(double time, int a, int b);
    }

    private static final class Disc {
        private int number;
        private double x;
        private double y;
        private double vx;
        private double vy;
        private double radius;
        private double mass;
        private int impacts;
    }

    /** A predicted impact of two discs, or of one with a vertical wall (b is null) or a horizontal one (a is null). */
    private record Event(double time, Disc a, Disc b, int impactsOfA, int impactsOfB) implements Comparable<Event> {

        Event(double time, Disc a, Disc b) {
            this(time, a, b, a == null ? 0 : a.impacts, b == null ? 0 : b.impacts);
        }

        boolean isStale() {
            return a != null && a.impacts != impactsOfA || b != null && b.impacts != impactsOfB;
        }

        @Override
        public int compareTo(Event other) {
            return Double.compare(time, other.time);
        }
    }

    private final Disc[] discs;
    private final double side;
    private final Listener listener;
    private final PriorityQueue<Event> queue = new PriorityQueue<>();
    private double now;
    private long impacts;

    /**
     * @param bodies with positions and velocities, inside the box from (0, 0) to (side, side)
     * @throws IllegalArgumentException if one is not inside
     */
    public TextbookSimulator(Bodies bodies, double side, Listener listener) {
        this.side = side;
        this.listener = listener;
        discs = new Disc[bodies.size()];
        for (int k = 0; k < discs.length; k++) {
            double r = bodies.radius[k];
            if (!(bodies.x[k] >= r && bodies.x[k] <= side - r && bodies.y[k] >= r && bodies.y[k] <= side - r)) {
                throw new IllegalArgumentException("body " + bodies.id(k) + " at (" + bodies.x[k] + ", " + bodies.y[k]
                    + "), expected inside a box of " + side);
            }
            Disc disc = new Disc();
            disc.number = k;
            disc.x = bodies.x[k];
            disc.y = bodies.y[k];
            disc.vx = bodies.vx[k];
            disc.vy = bodies.vy[k];
            disc.radius = r;
            disc.mass = bodies.mass[k];
            discs[k] = disc;
        }
        Arrays.stream(discs).forEach(this::predict);
    }

    /** Simulates until there have been this many impacts in all. */
    public void play(long untilImpacts) {
        while (impacts < untilImpacts && !queue.isEmpty()) {
            Event event = queue.poll();
            if (event.isStale()) {
                continue;
            }
            for (Disc disc : discs) {
                disc.x += disc.vx * (event.time - now);
                disc.y += disc.vy * (event.time - now);
            }
            now = event.time;
            impacts++;
            bounce(event.a, event.b);
            listener.impact(now, event.a == null ? -1 : event.a.number, event.b == null ? -1 : event.b.number);
            predict(event.a);
            predict(event.b);
        }
    }

    /** Returns how many impacts there have been, including those with walls. */
    public long impacts() {
        return impacts;
    }

    /** Queues the next impacts of a disc with every other disc and with the walls. */
    private void predict(Disc disc) {
        if (disc == null) {
            return;
        }
        for (Disc other : discs) {
            if (other != disc) {
                offer(timeToHit(disc, other), disc, other);
            }
        }
        offer(timeToHitWall(disc.x, disc.vx, disc.radius), disc, null);
        offer(timeToHitWall(disc.y, disc.vy, disc.radius), null, disc);
    }

    private void offer(double time, Disc a, Disc b) {
        if (time < Double.POSITIVE_INFINITY) {
            queue.add(new Event(now + time, a, b));
        }
    }

    /** The time t at which |d + v t| is the sum of the radii, with d from a to b. */
    private static double timeToHit(Disc a, Disc b) {
        double dx = b.x - a.x;
        double dy = b.y - a.y;
        double dvx = b.vx - a.vx;
        double dvy = b.vy - a.vy;
        double dv = dx * dvx + dy * dvy;
        if (dv >= 0) {
            return Double.POSITIVE_INFINITY;
        }
        double vv = dvx * dvx + dvy * dvy;
        double reach = a.radius + b.radius;
        double root = dv * dv - vv * (dx * dx + dy * dy - reach * reach);
        return root < 0 ? Double.POSITIVE_INFINITY : Math.max(0, -(dv + Math.sqrt(root)) / vv);
    }

    private double timeToHitWall(double place, double speed, double radius) {
        return speed == 0 ? Double.POSITIVE_INFINITY
            : Math.max(0, speed > 0 ? (side - radius - place) / speed : (radius - place) / speed);
    }

    /** Exchanges the elastic impulse 2 ma mb (v.d) / ((ma + mb) |d|) along d, or turns round at a wall. */
    private static void bounce(Disc a, Disc b) {
        if (a != null && b != null) {
            double dx = b.x - a.x;
            double dy = b.y - a.y;
            double reach = a.radius + b.radius;
            double dv = dx * (b.vx - a.vx) + dy * (b.vy - a.vy);
            double impulse = 2 * a.mass * b.mass * dv / ((a.mass + b.mass) * reach * reach);
            a.vx += impulse * dx / a.mass;
            a.vy += impulse * dy / a.mass;
            b.vx -= impulse * dx / b.mass;
            b.vy -= impulse * dy / b.mass;
        } else if (a != null) {
            a.vx = -a.vx;
        } else {
            b.vy = -b.vy;
        }
        if (a != null) {
            a.impacts++;
        }
        if (b != null) {
            b.impacts++;
        }
    }
}
