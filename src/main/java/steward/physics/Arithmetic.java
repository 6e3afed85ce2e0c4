package steward.physics;

/** With how much care a time of impact between two circles is computed. */
public enum Arithmetic {

    /** The published referee's own expressions, {@link TimeOfImpact#circlesOfficial}: the same bits as the server. */
    OFFICIAL {
        @Override
        double circles(double dx, double dy, double dvx, double dvy, double touch) {
            return TimeOfImpact.circlesOfficial(dx, dy, dvx, dvy, touch);
        }
    },

    /** The closed form without cancellation, {@link TimeOfImpact#circles}. */
    DOUBLE {
        @Override
        double circles(double dx, double dy, double dvx, double dvy, double touch) {
            return TimeOfImpact.circles(dx, dy, dvx, dvy, touch);
        }
    };

    /** Time until two circles that do not touch now will; see {@link TimeOfImpact}. */
    abstract double circles(double dx, double dy, double dvx, double dvy, double touch);
}
