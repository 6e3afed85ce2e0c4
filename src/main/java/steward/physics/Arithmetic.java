package steward.physics;

import java.util.Locale;
import steward.numerics.DoubleDouble;

/** With how much care a time of impact between two circles is computed. */
public enum Arithmetic {

    /** The published referee's own expressions, {@link TimeOfImpact#circlesOfficial}: the same bits as the server. */
    OFFICIAL {
        @Override
        double circles(double dx, double dy, double dvx, double dvy, double touch) {
            return TimeOfImpact.circlesOfficial(dx, dy, dvx, dvy, touch);
        }

        /** Next to the touch the official roots are all rounding, and one that is not above 0 counts as a miss. */
        @Override
        double approachingCircles(double dx, double dy, double dvx, double dvy, double touch) {
            return dx * dx + dy * dy - touch * touch <= ROUNDING * touch * touch
                ? 0 : TimeOfImpact.circlesOfficial(dx, dy, dvx, dvy, touch);
        }
    },

    /** The closed form without cancellation, {@link TimeOfImpact#circles}. */
    DOUBLE {
        @Override
        double circles(double dx, double dy, double dvx, double dvy, double touch) {
            return TimeOfImpact.circles(dx, dy, dvx, dvy, touch);
        }

        @Override
        double approachingCircles(double dx, double dy, double dvx, double dvy, double touch) {
            return TimeOfImpact.circles(dx, dy, dvx, dvy, touch);
        }
    },

    /** The same quadratic with the errors of its products and sums put back, {@link CompensatedTime}. */
    COMPENSATED {
        @Override
        double circles(double dx, double dy, double dvx, double dvy, double touch) {
            return CompensatedTime.circles(dx, dy, dvx, dvy, touch);
        }

        @Override
        double approachingCircles(double dx, double dy, double dvx, double dvy, double touch) {
            return CompensatedTime.circles(dx, dy, dvx, dvy, touch);
        }
    },

    /**
     * Exact decisions, {@link ExactCircles}: who touches, approaches or meets is a matter of exact signs, and times of
     * impact, positions at impacts, impulses and new velocities are computed in double-double and rounded once, when
     * they are stored. An {@link EventAdvance} does this for the impacts that happen, on lower bounds for the others;
     * here each call computes a time, and allocates.
     */
    EXACT {
        @Override
        double circles(double dx, double dy, double dvx, double dvy, double touch) {
            DoubleDouble time = new DoubleDouble();
            boolean hit = new ExactCircles().load(dx, 0, dy, 0, dvx, 0, dvy, 0, touch, 0).first(time);
            return hit ? time.high() : Double.POSITIVE_INFINITY;
        }

        @Override
        double approachingCircles(double dx, double dy, double dvx, double dvy, double touch) {
            return circles(dx, dy, dvx, dvy, touch);
        }
    };

    /** Its name in a scene. */
    public String text() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** Of the square of a distance: 32 roundings, against which the official root is known to about three. */
    private static final double ROUNDING = 0x1p-48;

    /** Time until two circles that do not touch now will; see {@link TimeOfImpact}. */
    abstract double circles(double dx, double dy, double dvx, double dvy, double touch);

    /** The same where only approach reacts: two that approach and touch but for a rounding must not be missed. */
    abstract double approachingCircles(double dx, double dy, double dvx, double dvy, double touch);
}
