package steward.physics.time;

import steward.numerics.DoubleDouble;
import steward.physics.Arithmetic;

/** The time of impact of two circles, in one arithmetic. */
public abstract sealed class CircleTime {

    /**
     * Relative to the square of the touching distance: 32 roundings, while the official root is accurate to about
     * three.
     */
    private static final double ROUNDING = 0x1p-48;

    /** @return an instance for one thread at a time */
    public static CircleTime of(Arithmetic arithmetic) {
        return switch (arithmetic) {
            case OFFICIAL, FORMER_OFFICIAL -> new Official();
            case DOUBLE -> new Stable();
            case COMPENSATED -> new Compensated();
            case EXACT -> new Exact();
        };
    }

    /** The same for replays of formats 1 and 2, in which the compensated arithmetic rounded differences first. */
    static CircleTime ofFormerReplays(Arithmetic arithmetic) {
        return arithmetic == Arithmetic.COMPENSATED ? new RoundedDifferences() : of(arithmetic);
    }

    /**
     * Time until the impact of two circles.
     *
     * @param separatingReact whether they react when they touch even if they do not approach
     * @return 0 for an impact now
     */
    public double until(double x1, double x2, double y1, double y2, double vx1, double vx2, double vy1, double vy2,
                        double r1, double r2, boolean separatingReact) {
        double dx = x1 - x2;
        double dy = y1 - y2;
        double dvx = vx1 - vx2;
        double dvy = vy1 - vy2;
        if (!separatingReact && !(dx * dvx + dy * dvy < 0)) {
            return Double.POSITIVE_INFINITY;
        }
        double touch = r1 + r2;
        if (Math.sqrt(dx * dx + dy * dy) <= touch) {
            return 0;
        }
        return separatingReact ? until(dx, dy, dvx, dvy, touch) : untilApproachingMeet(dx, dy, dvx, dvy, touch);
    }

    /** Time until two circles touch that do not touch now; see {@link TimeOfImpact}. */
    abstract double until(double dx, double dy, double dvx, double dvy, double touch);

    /**
     * The same for a law in which only approach reacts: an approaching pair that touches except for rounding errors
     * must not be missed.
     */
    public double untilApproachingMeet(double dx, double dy, double dvx, double dvy, double touch) {
        return until(dx, dy, dvx, dvy, touch);
    }

    /** {@link TimeOfImpact#circlesOfficial}. */
    private static final class Official extends CircleTime {

        @Override
        double until(double dx, double dy, double dvx, double dvy, double touch) {
            return TimeOfImpact.circlesOfficial(dx, dy, dvx, dvy, touch);
        }

        /**
         * Close to contact the official roots consist of rounding errors, and a root that is not above 0 counts as a
         * miss.
         */
        @Override
        public double untilApproachingMeet(double dx, double dy, double dvx, double dvy, double touch) {
            return dx * dx + dy * dy - touch * touch <= ROUNDING * touch * touch
                ? 0 : TimeOfImpact.circlesOfficial(dx, dy, dvx, dvy, touch);
        }
    }

    /** {@link TimeOfImpact#circles}. */
    private static final class Stable extends CircleTime {

        @Override
        double until(double dx, double dy, double dvx, double dvy, double touch) {
            return TimeOfImpact.circles(dx, dy, dvx, dvy, touch);
        }
    }

    /**
     * {@link CompensatedTime}, of the differences with their rounding errors; but where separating pairs react, of the
     * rounded differences, as the push-out sees them: otherwise a pair could react again and again.
     */
    private static final class Compensated extends CircleTime {

        @Override
        public double until(double x1, double x2, double y1, double y2, double vx1, double vx2, double vy1,
                            double vy2, double r1, double r2, boolean separatingReact) {
            return separatingReact ? super.until(x1, x2, y1, y2, vx1, vx2, vy1, vy2, r1, r2, true)
                : CompensatedTime.circles(x1, x2, y1, y2, vx1, vx2, vy1, vy2, r1, r2);
        }

        @Override
        double until(double dx, double dy, double dvx, double dvy, double touch) {
            return CompensatedTime.circles(dx, dy, dvx, dvy, touch);
        }
    }

    /** {@link CompensatedTime#circles}. */
    private static final class RoundedDifferences extends CircleTime {

        @Override
        double until(double dx, double dy, double dvx, double dvy, double touch) {
            return CompensatedTime.circles(dx, dy, dvx, dvy, touch);
        }
    }

    /**
     * {@link ExactCircles}, for callers that need only the time rounded to a double. The event loop does not use this:
     * it refines the times of impacts that happen and keeps lower bounds for the others.
     */
    private static final class Exact extends CircleTime {

        private final ExactCircles circles = new ExactCircles();
        private final DoubleDouble time = new DoubleDouble();

        @Override
        double until(double dx, double dy, double dvx, double dvy, double touch) {
            boolean hit = circles.load(dx, 0, dy, 0, dvx, 0, dvy, 0, touch, 0).firstTouch(time);
            return hit ? time.high() : Double.POSITIVE_INFINITY;
        }
    }
}
