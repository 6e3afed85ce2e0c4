package steward.bench.textbook;

import java.util.Arrays;
import java.util.PriorityQueue;
import steward.physics.Bodies;

/**
 * Elastic discs in a square box as a textbook simulates them, a baseline for other ways: a priority queue of all
 * predicted impacts; after an impact, a body is predicted anew against every other one, and an event is dropped when it
 * is due if one of its two bodies has had another impact since (R. Sedgewick, K. Wayne, "Algorithms", 4th edition,
 * section 6.1). Plain formulas, an object per body and event, all bodies move at every impact. It shares nothing with
 * the physics of Steward but the list of bodies it starts from.
 */
public final class TextbookCrowd {

    /** A body of the crowd. */
    private static final class Disc {
        private double x;
        private double y;
        private double vx;
        private double vy;
        private final double radius;
        private final double mass;
        private int impacts;

        Disc(double x, double y, double vx, double vy, double radius, double mass) {
            this.x = x;
            this.y = y;
            this.vx = vx;
            this.vy = vy;
            this.radius = radius;
            this.mass = mass;
        }
    }

    /** A predicted impact of two discs, or of one with a vertical wall (b is null) or a horizontal one (a is null). */
    private record Event(double time, Disc a, Disc b, int impactsOfA, int impactsOfB) implements Comparable<Event> {

        Event(double time, Disc a, Disc b) {
            this(time, a, b, a == null ? 0 : a.impacts, b == null ? 0 : b.impacts);
        }

        boolean isOver() {
            return a != null && a.impacts != impactsOfA || b != null && b.impacts != impactsOfB;
        }

        @Override
        public int compareTo(Event other) {
            return Double.compare(time, other.time);
        }
    }

    private final Disc[] discs;
    private final double side;
    private final PriorityQueue<Event> queue = new PriorityQueue<>();
    private double now;
    private long impacts;

    /**
     * @param bodies with positions and velocities, inside the box from (0, 0) to (side, side)
     * @throws IllegalArgumentException if one is not inside
     */
    public TextbookCrowd(Bodies bodies, double side) {
        this.side = side;
        discs = new Disc[bodies.size()];
        for (int k = 0; k < discs.length; k++) {
            double r = bodies.radius[k];
            if (!(bodies.x[k] >= r && bodies.x[k] <= side - r && bodies.y[k] >= r && bodies.y[k] <= side - r)) {
                throw new IllegalArgumentException("body " + bodies.id(k) + " at (" + bodies.x[k] + ", " + bodies.y[k]
                    + "), expected inside a box of " + side);
            }
            discs[k] = new Disc(bodies.x[k], bodies.y[k], bodies.vx[k], bodies.vy[k], r, bodies.mass[k]);
        }
        Arrays.stream(discs).forEach(this::foresee);
    }

    /** Simulates until there have been this many impacts in all. */
    public void play(long untilImpacts) {
        while (impacts < untilImpacts && !queue.isEmpty()) {
            Event event = queue.poll();
            if (event.isOver()) {
                continue;
            }
            double time = event.time - now;
            for (Disc disc : discs) {
                disc.x += disc.vx * time;
                disc.y += disc.vy * time;
            }
            now = event.time;
            impacts++;
            react(event.a, event.b);
            if (event.a != null) {
                event.a.impacts++;
                foresee(event.a);
            }
            if (event.b != null) {
                event.b.impacts++;
                foresee(event.b);
            }
        }
    }

    /** How many impacts there have been, including those with walls. */
    public long impacts() {
        return impacts;
    }

    /** The total kinetic energy: the sum of half of mass times speed squared. */
    public double energy() {
        return Arrays.stream(discs).mapToDouble(d -> d.mass * (d.vx * d.vx + d.vy * d.vy) / 2).sum();
    }

    private void foresee(Disc disc) {
        for (Disc other : discs) {
            if (other != disc) {
                offer(timeToHit(disc, other), disc, other);
            }
        }
        offer(timeToWall(disc.x, disc.vx, disc.radius), disc, null);
        offer(timeToWall(disc.y, disc.vy, disc.radius), null, disc);
    }

    private void offer(double time, Disc a, Disc b) {
        if (time < Double.POSITIVE_INFINITY) {
            queue.add(new Event(now + time, a, b));
        }
    }

    private static double timeToHit(Disc a, Disc b) {
        double dx = b.x - a.x;
        double dy = b.y - a.y;
        double dvx = b.vx - a.vx;
        double dvy = b.vy - a.vy;
        double closing = dx * dvx + dy * dvy;
        if (closing >= 0) {
            return Double.POSITIVE_INFINITY;
        }
        double speed = dvx * dvx + dvy * dvy;
        double reach = a.radius + b.radius;
        double root = closing * closing - speed * (dx * dx + dy * dy - reach * reach);
        return root < 0 ? Double.POSITIVE_INFINITY : Math.max(0, -(closing + Math.sqrt(root)) / speed);
    }

    private double timeToWall(double place, double speed, double radius) {
        if (speed == 0) {
            return Double.POSITIVE_INFINITY;
        }
        return Math.max(0, speed > 0 ? (side - radius - place) / speed : (radius - place) / speed);
    }

    private static void react(Disc a, Disc b) {
        if (b == null) {
            a.vx = -a.vx;
        } else if (a == null) {
            b.vy = -b.vy;
        } else {
            double dx = b.x - a.x;
            double dy = b.y - a.y;
            double reach = a.radius + b.radius;
            double closing = dx * (b.vx - a.vx) + dy * (b.vy - a.vy);
            double push = 2 * a.mass * b.mass * closing / ((a.mass + b.mass) * reach * reach);
            a.vx += push * dx / a.mass;
            a.vy += push * dy / a.mass;
            b.vx -= push * dx / b.mass;
            b.vy -= push * dy / b.mass;
        }
    }
}
