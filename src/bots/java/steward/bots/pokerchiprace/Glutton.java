package steward.bots.pokerchiprace;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

/**
 * The better bot. For each chip it looks at waiting and at up to three pushes in each of 24 directions, flies all other
 * chips straight on, and takes the way on which the chip has eaten most, and soonest, without being eaten itself.
 */
public final class Glutton extends ChipBot {

    private static final int DIRECTIONS = 24;
    /** The directions are a length apart from the chip at which it pushes itself, in u. */
    private static final double FAR = 100;
    /** How many turns it looks ahead, in steps of a third of a turn. */
    private static final int STEPS = 120;
    private static final int STEPS_OF_TURN = 3;
    private static final double STEP = 1.0 / STEPS_OF_TURN;
    /** Discount of a gain: its worth is multiplied by this with each step. */
    private static final double PATIENCE = 0.988;
    /** Speed that a push gives to a chip, in u per turn, and the share of its area that it leaves. */
    private static final double PUSH = 200.0 / 14;
    private static final double LEFT = 14.0 / 15;
    /** The most pushes in a row that it looks at. */
    private static final int PUSHES = 3;
    /** A bigger chip is avoided from this distance on, in u; it may grow or turn. */
    private static final double MARGIN = 4;
    /** Margin by which a rival may come nearer than it seems, in u per turn and in all. */
    private static final double CHASE = 3;
    private static final double MOST_CHASE = 40;
    /** Worth of a rival's chip, as a multiple of its area. */
    private static final double RIVAL = 1.5;
    /** Being eaten costs as much as this many times the chip. */
    private static final double FEAR = 2;
    /** A way must be better by this share of the area than waiting. */
    private static final double WORTH = 0.01;

    /** Plays one match over the standard streams. */
    public static void main(String[] arguments) throws IOException {
        new Glutton().run();
    }

    @Override
    double[] decide(Chip chip) {
        List<Chip> others = new ArrayList<>();
        for (Chip other : chips) {
            if (other != chip) {
                others.add(other);
            }
        }
        double area = chip.radius * chip.radius;
        double best = worth(others, chip, 0, 0, 0) + WORTH * area;
        double[] way = null;
        for (int k = 0; k < DIRECTIONS; k++) {
            double angle = 2 * Math.PI * k / DIRECTIONS;
            double x = Math.cos(angle);
            double y = Math.sin(angle);
            for (int pushes = 1; pushes <= PUSHES; pushes++) {
                double worth = worth(others, chip, x, y, pushes);
                if (worth > best) {
                    best = worth;
                    way = new double[] {FAR * x, FAR * y};
                }
            }
        }
        return way;
    }

    /**
     * The area that the chip will have, in which what comes late counts less; areas are without the factor pi.
     *
     * @param x      the direction of its pushes, one a turn
     * @param pushes how many there are
     */
    private double worth(List<Chip> others, Chip chip, double x, double y, int pushes) {
        double[] me = {chip.x, chip.y, chip.vx, chip.vy};
        double now = chip.radius * chip.radius;
        double radius = chip.radius;
        double worth = now;
        double weight = 1;
        boolean[] eaten = new boolean[others.size()];
        for (int step = 1; step <= STEPS; step++) {
            weight *= PATIENCE;
            if (step % STEPS_OF_TURN == 1 && step / STEPS_OF_TURN < pushes && radius > SMALL) {
                me[2] += PUSH * x;
                me[3] += PUSH * y;
                worth -= (1 - LEFT) * now;
                now *= LEFT;
                radius = Math.sqrt(now);
            }
            fly(me, radius);
            for (int k = 0; k < eaten.length; k++) {
                Chip other = others.get(k);
                double dx = folded(other.x + other.vx * STEP * step, HALF_WIDTH - other.radius) - me[0];
                double dy = folded(other.y + other.vy * STEP * step, HALF_HEIGHT - other.radius) - me[1];
                boolean smaller = other.radius < radius;
                double reach = other.radius + radius + (smaller ? 0 : margin(other, chip, step));
                if (eaten[k] || dx * dx + dy * dy >= reach * reach) {
                    continue;
                }
                eaten[k] = true;
                double gain = other.radius * other.radius;
                if (!smaller) {
                    return other.player == chip.player ? worth : worth - FEAR * weight * now;
                }
                double all = now + gain;
                me[2] = (me[2] * now + other.vx * gain) / all;
                me[3] = (me[3] * now + other.vy * gain) / all;
                now = all;
                radius = Math.sqrt(now);
                worth += weight * gain * worthOf(other, chip);
            }
        }
        return worth;
    }

    /** Bigger chips of rivals may come after it. */
    private static double margin(Chip bigger, Chip chip, int step) {
        return bigger.player == chip.player ? 0 : bigger.player < 0 ? MARGIN
            : MARGIN + Math.min(MOST_CHASE, CHASE * STEP * step);
    }

    /** Returns the worth of a meal: a rival's chip counts more, one of the own side nothing. */
    private static double worthOf(Chip prey, Chip chip) {
        return prey.player == chip.player ? 0 : prey.player < 0 ? 1 : RIVAL;
    }

    private static void fly(double[] me, double radius) {
        me[0] += me[2] * STEP;
        me[1] += me[3] * STEP;
        if (Math.abs(me[0]) > HALF_WIDTH - radius) {
            me[0] = folded(me[0], HALF_WIDTH - radius);
            me[2] = -me[2];
        }
        if (Math.abs(me[1]) > HALF_HEIGHT - radius) {
            me[1] = folded(me[1], HALF_HEIGHT - radius);
            me[3] = -me[3];
        }
    }

    /** Returns where a place beyond a wall is after the bounces. */
    private static double folded(double place, double wall) {
        double folded = place;
        for (int bounce = 0; Math.abs(folded) > wall && bounce < 20; bounce++) {
            folded = folded > 0 ? 2 * wall - folded : -2 * wall - folded;
        }
        return folded;
    }
}
