package steward.physics.impulse;

import steward.physics.Bodies;
import steward.physics.ImpactLaw;
import steward.physics.TurnSink;
import steward.physics.Wall;

/**
 * The parts of a reaction that depend on the law, chosen once for a scene: what the law lacks costs nothing at an
 * impact. The impulse is such a part too: {@link Impulse}.
 *
 * @param restitutionRule the restitution of an impact
 * @param separation      how a residual approach is treated after an impulse
 * @param correction      how overlaps are treated after an impulse
 */
record CollisionParts(RestitutionRule restitutionRule, Separation separation, PositionalCorrection correction) {

    static CollisionParts of(ImpactLaw law) {
        return new CollisionParts(
            law.restitution() == ImpactLaw.Restitution.ELASTIC ? new RestitutionRule.Elastic()
            : new RestitutionRule.Minimum(),
            law.separatingPairsReact() ? new Separation.None() : new Separation.Enforced(),
            Double.isNaN(law.pushOut()) ? new PositionalCorrection.None() : new PositionalCorrection.Split());
    }

    /** The restitution of an impact, 0..1. */
    sealed interface RestitutionRule {

        /** For two bodies. */
        double betweenBodies(Bodies bodies, int a, int b);

        /** For a body and a wall. */
        double atWall(Bodies bodies, int a, Wall wall);

        /** Every impact is elastic. */
        final class Elastic implements RestitutionRule {

            @Override
            public double betweenBodies(Bodies bodies, int a, int b) {
                return 1;
            }

            @Override
            public double atWall(Bodies bodies, int a, Wall wall) {
                return 1;
            }
        }

        /** The lower of the two. */
        final class Minimum implements RestitutionRule {

            @Override
            public double betweenBodies(Bodies bodies, int a, int b) {
                return Math.min(bodies.restitution[a], bodies.restitution[b]);
            }

            @Override
            public double atWall(Bodies bodies, int a, Wall wall) {
                return Math.min(bodies.restitution[a], wall.restitution());
            }
        }
    }

    /** Whether a pair must not approach after its impulse, see {@link Collision#removeResidualApproach}. */
    sealed interface Separation {

        void enforce(Collision of, Bodies bodies, int a, int b, double nx, double ny, double speeds);

        /** Only approach reacts, so a residual approach would react again at once: it is removed. */
        final class Enforced implements Separation {

            @Override
            public void enforce(Collision of, Bodies bodies, int a, int b, double nx, double ny, double speeds) {
                of.removeResidualApproach(bodies, a, b, nx, ny, speeds);
            }
        }

        /** Separating pairs react too: nothing to do. */
        final class None implements Separation {

            @Override
            public void enforce(Collision of, Bodies bodies, int a, int b, double nx, double ny, double speeds) {
            }
        }
    }

    /** Positional correction after an impulse. */
    sealed interface PositionalCorrection {

        void correctPair(Collision of, Bodies bodies, int a, int b, double nx, double ny, double distance, double time,
                         TurnSink sink);

        void correctFromWall(Collision of, Bodies bodies, int a, double nx, double ny, double gap, double time,
                             TurnSink sink);

        /** None, except for the rounding errors of positions at walls. */
        final class None implements PositionalCorrection {

            @Override
            public void correctPair(Collision of, Bodies bodies, int a, int b, double nx, double ny, double distance,
                                    double time, TurnSink sink) {
            }

            @Override
            public void correctFromWall(Collision of, Bodies bodies, int a, double nx, double ny, double gap,
                                        double time, TurnSink sink) {
                of.cancelRoundingPenetration(bodies, a, nx, ny, gap);
            }
        }

        /** The overlap is split between the two, plus the law's {@code pushOut}. */
        final class Split implements PositionalCorrection {

            @Override
            public void correctPair(Collision of, Bodies bodies, int a, int b, double nx, double ny, double distance,
                                    double time, TurnSink sink) {
                of.correctPair(bodies, a, b, nx, ny, distance, time, sink);
            }

            @Override
            public void correctFromWall(Collision of, Bodies bodies, int a, double nx, double ny, double gap,
                                        double time, TurnSink sink) {
                of.correctFromWall(bodies, a, nx, ny, gap, time, sink);
            }
        }
    }
}
