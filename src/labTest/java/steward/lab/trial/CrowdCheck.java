package steward.lab.trial;

import java.util.Locale;
import steward.physics.Advance;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;
import steward.physics.TurnSink;

/*
 * The overlap that rounding explains. A time within the turn is known to 2^-53, so two bodies that approach at speed u
 * meet up to u 2^-53 too early or too late; each of their four coordinates is rounded when they are moved there and
 * when they are checked, half a unit in the last place of the side each time. Together less than 2^-52 u + 8 ulp(side),
 * u at most the sum of their speeds. A deeper overlap means that an impact was missed.
 *
 * The official expressions lose more: D = b^2 - a c, with b^2 and a c up to a d^2, is wrong by up to 2^-51 a d^2, the
 * time by 1 / (2 a sqrt D) of that, and the distance, which changes at sqrt D / s when they touch at s = 2, by 2^-53
 * d^2. No distance is longer than the diagonal: 2^-52 side^2.
 */

/**
 * Check of a crowd that is played for many impacts: after each turn and at each impact, whether any was missed. It
 * looks for discs that overlap or have left the box by more than rounding, impacts of discs that do not touch, and
 * drift of the energy. It checks all pairs with code of its own.
 */
public final class CrowdCheck {

    private static final int IDLE_TURNS = 100;

    private CrowdCheck() { }

    /**
     * Result of a trial.
     *
     * @param impacts      how many impacts there were
     * @param turns        in how many turns
     * @param overlaps     pairs that overlap more than rounding explains, counted at the end of each turn
     * @param escapes      discs farther outside the box than that, likewise
     * @param apart        impacts of discs farther from touching than that
     * @param worstGap     largest distance of an impact from an exact touch, in radii, to either side
     * @param drift        relative change of the energy
     */
    public record Result(long impacts, long turns, long overlaps, long escapes, long apart, double worstGap,
                         double drift) {

        /** True if no impact was missed and no disc escaped. */
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
     * Plays until there have been the given number of impacts, or none in {@value #IDLE_TURNS} turns in a row.
     *
     * @param rung whose {@link Rung#crowdAdvance} is tested
     */
    public static Result run(Gas gas, Rung rung, long impacts) {
        return run(gas.bodies(), gas, rung, impacts);
    }

    /** Plays given bodies in the box of a gas. */
    static Result run(Bodies bodies, Gas gas, Rung rung, long impacts) {
        Advance advance = rung.crowdAdvance(ImpactLaw.PHYSICS.withMaximumImpacts(Integer.MAX_VALUE), gas.walls());
        Watch watch = new Watch(bodies, gas.side(), rung.arithmetic().isOfficial());
        while (watch.impacts < impacts && watch.idle < IDLE_TURNS) {
            long before = watch.impacts;
            advance.turn(bodies, watch);
            watch.end();
            watch.idle = watch.impacts > before ? 0 : watch.idle + 1;
        }
        return watch.result();
    }

    /** Checks the bodies, sorted along x. */
    private static final class Watch implements TurnSink {

        private final Bodies bodies;
        private final double side;
        private final int[] order;
        private long impacts;
        private long turns;
        private int idle;
        private long overlaps;
        private long escapes;
        private long apart;
        private double worst;
        private final double energy;
        private final double cancellation;

        Watch(Bodies bodies, double side, boolean official) {
            this.bodies = bodies;
            this.side = side;
            cancellation = official ? 0x1p-52 * side * side : 0;
            order = new int[bodies.size()];
            for (int k = 0; k < order.length; k++) {
                order[k] = k;
            }
            energy = energy();
        }

        Result result() {
            return new Result(impacts, turns, overlaps, escapes, apart, worst, Math.abs(energy() - energy) / energy);
        }

        private double energy() {
            double sum = 0;
            for (int k = 0; k < bodies.size(); k++) {
                sum += bodies.vx[k] * bodies.vx[k] + bodies.vy[k] * bodies.vy[k];
            }
            return sum;
        }

        private double allowed(double vx, double vy, double otherVx, double otherVy) {
            return cancellation + 8 * Math.ulp(side) + 0x1p-52 * (Math.hypot(vx, vy) + Math.hypot(otherVx, otherVy));
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

        /** Insertion sort: from turn to turn few bodies change places. */
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
