package steward.physics.time;

import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;

/** Time of the next impact of a pair of circles. The law decides if a touching pair reacts; the rest is geometry. */
public abstract sealed class PairTime permits PairTime.OfCircles, PairTime.Overlap, ExactPairs {

    private static final double NEVER = Double.POSITIVE_INFINITY;

    /**
     * Time from now to the impact of two circles, given by their indices; 0 for an impact now. A time beyond the turn
     * may be given as infinite.
     *
     * @param ri with rj, the radii in their contact
     */
    public abstract double until(Bodies bodies, int i, int j, double ri, double rj);

    public static PairTime of(ImpactLaw law, Arithmetic arithmetic) {
        return new OfCircles(CircleTime.of(arithmetic), law.separatingPairsReact());
    }

    /** By {@link CircleTime}, of pairs that are not surely too far. */
    static final class OfCircles extends PairTime {

        private final CircleTime circles;
        private final boolean separatingReact;

        OfCircles(CircleTime circles, boolean separatingReact) {
            this.circles = circles;
            this.separatingReact = separatingReact;
        }

        @Override
        public double until(Bodies bodies, int i, int j, double ri, double rj) {
            double x1 = bodies.x[i];
            double x2 = bodies.x[j];
            double y1 = bodies.y[i];
            double y2 = bodies.y[j];
            double vx1 = bodies.vx[i];
            double vx2 = bodies.vx[j];
            double vy1 = bodies.vy[i];
            double vy2 = bodies.vy[j];
            return CircleTime.areFar(x1 - x2, y1 - y2, vx1 - vx2, vy1 - vy2, ri + rj) ? NEVER
                : circles.until(x1, x2, y1, y2, vx1, vx2, vy1, vy2, ri, rj, separatingReact);
        }
    }

    /** Present overlaps only: 0 for a touching pair, never for the others. */
    public static final class Overlap extends PairTime {

        private final boolean closingOnly;

        /** @param closingOnly whether only approaching pairs count */
        public Overlap(boolean closingOnly) {
            this.closingOnly = closingOnly;
        }

        @Override
        public double until(Bodies bodies, int i, int j, double ri, double rj) {
            double dx = bodies.x[i] - bodies.x[j];
            double dy = bodies.y[i] - bodies.y[j];
            double touch = ri + rj;
            return dx * dx + dy * dy <= touch * touch && (!closingOnly
                || dx * (bodies.vx[i] - bodies.vx[j]) + dy * (bodies.vy[i] - bodies.vy[j]) < 0) ? 0 : NEVER;
        }
    }
}
