package steward.physics;

/** When a pair of circles next has an impact under a law: touching pairs are the law's affair, the rest geometry. */
abstract sealed class PairTime {

    /**
     * Time from now to the impact of two circles, 0 for one that happens at once.
     *
     * @param dx    from one centre to the other
     * @param dvx   velocity of that other relative to the one
     * @param touch the sum of the radii
     */
    abstract double until(double dx, double dy, double dvx, double dvy, double touch);

    static PairTime of(ImpactLaw law, Arithmetic arithmetic) {
        return law.separatingPairsReact() ? new TouchIsImpact(arithmetic) : new ApproachIsImpact(arithmetic);
    }

    /** The official games: whoever touches reacts, even while separating. */
    static final class TouchIsImpact extends PairTime {

        private final Arithmetic arithmetic;

        TouchIsImpact(Arithmetic arithmetic) {
            this.arithmetic = arithmetic;
        }

        @Override
        double until(double dx, double dy, double dvx, double dvy, double touch) {
            if (Math.sqrt(dx * dx + dy * dy) <= touch) {
                return 0;
            }
            return arithmetic.circles(dx, dy, dvx, dvy, touch);
        }
    }

    /** Physics: only an approach ends in an impact. */
    static final class ApproachIsImpact extends PairTime {

        private final Arithmetic arithmetic;

        ApproachIsImpact(Arithmetic arithmetic) {
            this.arithmetic = arithmetic;
        }

        @Override
        double until(double dx, double dy, double dvx, double dvy, double touch) {
            if (!(dx * dvx + dy * dvy < 0)) {
                return Double.POSITIVE_INFINITY;
            }
            if (Math.sqrt(dx * dx + dy * dy) <= touch) {
                return 0;
            }
            return arithmetic.approachingCircles(dx, dy, dvx, dvy, touch);
        }
    }
}
