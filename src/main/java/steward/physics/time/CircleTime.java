package steward.physics.time;

import steward.numerics.DoubleDouble;
import steward.physics.Arithmetic;

/** The time of impact of two circles, in one arithmetic. */
public abstract sealed class CircleTime {

    /** Of the square of a distance: 32 roundings, against which the official root is known to about three. */
    private static final double ROUNDING = 0x1p-48;

    /** @return one that may be used by one thread at a time */
    public static CircleTime of(Arithmetic arithmetic) {
        return switch (arithmetic) {
            case OFFICIAL -> new Official();
            case DOUBLE -> new Stable();
            case COMPENSATED -> new Compensated();
            case EXACT -> new Exact();
        };
    }

    /** Time until two circles that do not touch now will; see {@link TimeOfImpact}. */
    abstract double until(double dx, double dy, double dvx, double dvy, double touch);

    /** The same where only approach reacts: two that approach and touch but for a rounding must not be missed. */
    public double untilApproachingMeet(double dx, double dy, double dvx, double dvy, double touch) {
        return until(dx, dy, dvx, dvy, touch);
    }

    /** {@link TimeOfImpact#circlesOfficial}. */
    private static final class Official extends CircleTime {

        @Override
        double until(double dx, double dy, double dvx, double dvy, double touch) {
            return TimeOfImpact.circlesOfficial(dx, dy, dvx, dvy, touch);
        }

        /** Next to the touch the official roots are all rounding, and one that is not above 0 counts as a miss. */
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

    /** {@link CompensatedTime#circles}. */
    private static final class Compensated extends CircleTime {

        @Override
        double until(double dx, double dy, double dvx, double dvy, double touch) {
            return CompensatedTime.circles(dx, dy, dvx, dvy, touch);
        }
    }

    /**
     * {@link ExactCircles}, for the few who want a time and no more: the event loop refines the times of the impacts
     * that happen, on lower bounds for the others.
     */
    private static final class Exact extends CircleTime {

        private final ExactCircles circles = new ExactCircles();
        private final DoubleDouble time = new DoubleDouble();

        @Override
        double until(double dx, double dy, double dvx, double dvy, double touch) {
            boolean hit = circles.load(dx, 0, dy, 0, dvx, 0, dvy, 0, touch, 0).first(time);
            return hit ? time.high() : Double.POSITIVE_INFINITY;
        }
    }
}
