package steward.physics.time;

import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.ImpactLaw;

/**
 * The time of the next impact of a pair of circles. Whether a touching pair reacts depends on the law; the rest is
 * geometry.
 */
public abstract sealed class PairTime permits PairTime.TouchIsImpact, PairTime.ApproachIsImpact, PairTime.Overlap,
    PairTime.ClosingOverlap, PairTime.AtOwnDistance, ExactPairs {

    private static final double NEVER = Double.POSITIVE_INFINITY;

    /** Time from now to the impact of two circles, given by their indices; 0 for an impact now. */
    public abstract double until(Bodies bodies, int i, int j);

    public static PairTime of(ImpactLaw law, Arithmetic arithmetic) {
        return law.separatingPairsReact() ? new TouchIsImpact(CircleTime.of(arithmetic))
            : new ApproachIsImpact(arithmetic);
    }

    /** The same for replays of formats 1 and 2. */
    public static PairTime ofFormerReplays(ImpactLaw law, Arithmetic arithmetic) {
        CircleTime circles = CircleTime.ofFormerReplays(arithmetic);
        return law.separatingPairsReact() ? new TouchIsImpact(circles) : new ApproachIsImpact(circles);
    }

    /** The official games: a touching pair reacts, even while separating. */
    static final class TouchIsImpact extends PairTime {

        private final CircleTime circles;

        TouchIsImpact(CircleTime circles) {
            this.circles = circles;
        }

        @Override
        public double until(Bodies bodies, int i, int j) {
            return circles.until(bodies.x[i], bodies.x[j], bodies.y[i], bodies.y[j], bodies.vx[i], bodies.vx[j],
                bodies.vy[i], bodies.vy[j], bodies.radius[i], bodies.radius[j], true);
        }
    }

    /** Physics: only an approach ends in an impact. */
    public static final class ApproachIsImpact extends PairTime {

        private final CircleTime circles;

        public ApproachIsImpact(Arithmetic arithmetic) {
            this(CircleTime.of(arithmetic));
        }

        ApproachIsImpact(CircleTime circles) {
            this.circles = circles;
        }

        @Override
        public double until(Bodies bodies, int i, int j) {
            return circles.until(bodies.x[i], bodies.x[j], bodies.y[i], bodies.y[j], bodies.vx[i], bodies.vx[j],
                bodies.vy[i], bodies.vy[j], bodies.radius[i], bodies.radius[j], false);
        }
    }

    /** The times of another, for contacts some of which begin at a distance of their own. */
    public static final class AtOwnDistance extends PairTime {

        private final PairTime time;
        private final ContactDistance distance;

        public AtOwnDistance(PairTime time, Contacts contacts) {
            this.time = time;
            distance = new ContactDistance(contacts);
        }

        @Override
        public double until(Bodies bodies, int i, int j) {
            boolean own = distance.enter(bodies, i, j);
            double until = time.until(bodies, i, j);
            if (own) {
                distance.leave(bodies, i, j);
            }
            return until;
        }
    }

    /** Present overlaps only: 0 for a touching pair, never for the others. */
    public static final class Overlap extends PairTime {

        @Override
        public double until(Bodies bodies, int i, int j) {
            double dx = bodies.x[i] - bodies.x[j];
            double dy = bodies.y[i] - bodies.y[j];
            double touch = bodies.radius[i] + bodies.radius[j];
            return dx * dx + dy * dy <= touch * touch ? 0 : NEVER;
        }
    }

    /** Present overlaps of approaching pairs only. */
    public static final class ClosingOverlap extends PairTime {

        @Override
        public double until(Bodies bodies, int i, int j) {
            double dx = bodies.x[i] - bodies.x[j];
            double dy = bodies.y[i] - bodies.y[j];
            double touch = bodies.radius[i] + bodies.radius[j];
            return dx * dx + dy * dy <= touch * touch
                && dx * (bodies.vx[i] - bodies.vx[j]) + dy * (bodies.vy[i] - bodies.vy[j]) < 0 ? 0 : NEVER;
        }
    }
}
