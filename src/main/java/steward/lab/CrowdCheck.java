package steward.lab;

import java.util.List;
import java.util.Locale;
import java.util.function.LongConsumer;
import steward.physics.Advance;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.QueueAdvance;
import steward.physics.TurnSink;

/*
 * What rounding allows. A time within the turn is known to 2^-53, so that two that close in at speed u meet up to
 * u 2^-53 too early or too late; each of their four coordinates is rounded when they are flown there and when they are
 * looked at, half a unit in the last place of the side each time. Together less than 2^-52 u + 8 ulp(side), u at most
 * the sum of their speeds. Deeper, and an impact was missed.
 */

/**
 * Plays a crowd on for many impacts and looks, after each turn and at each impact, whether any was missed: discs that
 * overlap or have left the box by more than rounding, impacts of discs that do not touch, and how far the energy has
 * drifted. Looks at all pairs with code of its own.
 */
public final class CrowdCheck {

    private CrowdCheck() {
    }

    /**
     * What was seen.
     *
     * @param impacts      how many there were
     * @param turns        and in how many turns
     * @param overlaps     pairs deeper in each other than rounding explains, counted at the end of each turn
     * @param escapes      discs further outside the box than that, likewise
     * @param apart        impacts of discs further from touching than that
     * @param worstGap     the furthest that an impact was from an exact touch, in radii, to either side
     * @param drift        by how much the energy has changed, relative to itself
     */
    public record Result(long impacts, long turns, long overlaps, long escapes, long apart, double worstGap,
                         double drift) {

        /** Whether nothing was missed and nobody escaped. */
        public boolean isRight() {
            return overlaps == 0 && escapes == 0 && apart == 0;
        }

        @Override
        public String toString() {
            return String.format(Locale.ROOT, "%d impacts in %d turns: %d overlaps, %d escapes, %d impacts without "
                + "touch; at most %.1e radii off a touch; energy off by %.1e", impacts, turns, overlaps, escapes, apart,
                worstGap, drift);
        }
    }

    /**
     * Plays until there have been so many impacts.
     *
     * @param progress told after each turn how many there have been
     */
    public static Result run(Gas gas, Arithmetic arithmetic, long impacts, LongConsumer progress) {
        return run(gas.bodies(), gas, arithmetic, impacts, progress);
    }

    /** The same with bodies of one's own in the box of a gas. */
    static Result run(Bodies bodies, Gas gas, Arithmetic arithmetic, long impacts, LongConsumer progress) {
        Advance advance = new QueueAdvance(new PhysicsParts(ImpactLaw.PHYSICS.withMaximumImpacts(Integer.MAX_VALUE),
            arithmetic, new Contacts(1), List.of(gas.walls()), null, false));
        Watch watch = new Watch(bodies, gas.side());
        double energy = watch.energy();
        while (watch.impacts < impacts) {
            advance.turn(bodies, watch);
            watch.end();
            progress.accept(watch.impacts);
        }
        return new Result(watch.impacts, watch.turns, watch.overlaps, watch.escapes, watch.apart, watch.worst,
            Math.abs(watch.energy() - energy) / energy);
    }

    /** Looks at the bodies, sorted along x. */
    private static final class Watch implements TurnSink {

        private final Bodies bodies;
        private final double side;
        private final int[] order;
        private long impacts;
        private long turns;
        private long overlaps;
        private long escapes;
        private long apart;
        private double worst;

        Watch(Bodies bodies, double side) {
            this.bodies = bodies;
            this.side = side;
            order = new int[bodies.size()];
            for (int k = 0; k < order.length; k++) {
                order[k] = k;
            }
        }

        double energy() {
            double sum = 0;
            for (int k = 0; k < bodies.size(); k++) {
                sum += bodies.vx[k] * bodies.vx[k] + bodies.vy[k] * bodies.vy[k];
            }
            return sum;
        }

        private double allowed(double vx, double vy, double otherVx, double otherVy) {
            return 8 * Math.ulp(side) + 0x1p-52 * (Math.hypot(vx, vy) + Math.hypot(otherVx, otherVy));
        }

        @Override
        public void impact(double time, int a, int b, double ax, double ay, double bx, double by, double normalX,
                           double normalY, double impulse, double energy, double massA, double massB,
                           double vaxBefore, double vayBefore, double vaxAfter, double vayAfter,
                           double vbxBefore, double vbyBefore, double vbxAfter, double vbyAfter) {
            impacts++;
            double gap = b >= 0 ? Math.hypot(bx - ax, by - ay) - 2
                : Math.min(Math.min(ax, side - ax), Math.min(ay, side - ay)) - 1;
            worst = Math.max(worst, Math.abs(gap));
            apart += Math.abs(gap) <= allowed(vaxBefore, vayBefore, vbxBefore, vbyBefore) ? 0 : 1;
        }

        void end() {
            turns++;
            for (int k = 0; k < bodies.size(); k++) {
                double out = 1 - Math.min(Math.min(bodies.x[k], side - bodies.x[k]),
                    Math.min(bodies.y[k], side - bodies.y[k]));
                escapes += out <= allowed(bodies.vx[k], bodies.vy[k], 0, 0) ? 0 : 1;
            }
            sort();
            for (int k = 0; k < order.length; k++) {
                int i = order[k];
                for (int m = k + 1; m < order.length && bodies.x[order[m]] - bodies.x[i] < 2; m++) {
                    int j = order[m];
                    double overlap = 2 - Math.hypot(bodies.x[j] - bodies.x[i], bodies.y[j] - bodies.y[i]);
                    overlaps += overlap <= allowed(bodies.vx[i], bodies.vy[i], bodies.vx[j], bodies.vy[j]) ? 0 : 1;
                }
            }
        }

        /** By insertion: from turn to turn hardly anybody overtakes many. */
        private void sort() {
            for (int k = 1; k < order.length; k++) {
                int body = order[k];
                int place = k;
                while (place > 0 && bodies.x[order[place - 1]] > bodies.x[body]) {
                    order[place] = order[place - 1];
                    place--;
                }
                order[place] = body;
            }
        }
    }
}
