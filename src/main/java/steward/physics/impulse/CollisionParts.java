package steward.physics.impulse;

import steward.physics.Bodies;
import steward.physics.ImpactLaw;
import steward.physics.TurnSink;
import steward.physics.Wall;

/**
 * What a law adds to the reaction of two, put together once for a scene: a collision asks for none of it that the law
 * has not. The impulse itself is a part too: {@link Impulse}.
 *
 * @param givenBack how much of an approach
 * @param parting   what remains to be done when only approach reacts
 * @param pushing   of those that overlap
 */
record CollisionParts(RestitutionRule restitutionRule, Separation separation, PositionalCorrection correction) {

    static CollisionParts of(ImpactLaw law) {
        return new CollisionParts(
            law.restitution() == ImpactLaw.Restitution.ELASTIC ? new RestitutionRule.Elastic()
            : new RestitutionRule.Minimum(),
            law.separatingPairsReact() ? new Separation.Free() : new Separation.Enforced(),
            Double.isNaN(law.pushOut()) ? new PositionalCorrection.None() : new PositionalCorrection.Split());
    }

    /** The restitution of an impact, 0..1. */
    sealed interface RestitutionRule {

        double ofPair(Bodies bodies, int a, int b);

        double atWall(Bodies bodies, int a, Wall wall);

        /** Everything is elastic. */
        final class Elastic implements RestitutionRule {

            @Override
            public double ofPair(Bodies bodies, int a, int b) {
                return 1;
            }

            @Override
            public double atWall(Bodies bodies, int a, Wall wall) {
                return 1;
            }
        }

        /** The lesser of the two. */
        final class Minimum implements RestitutionRule {

            @Override
            public double ofPair(Bodies bodies, int a, int b) {
                return Math.min(bodies.restitution[a], bodies.restitution[b]);
            }

            @Override
            public double atWall(Bodies bodies, int a, Wall wall) {
                return Math.min(bodies.restitution[a], wall.restitution());
            }
        }
    }

    /** See {@link Collision#endApproach}. */
    sealed interface Separation {

        void end(Collision of, Bodies bodies, int a, int b, double nx, double ny, double speeds);

        /** Those that still approach would react again at once: what rounding has left of it is taken away. */
        final class Enforced implements Separation {

            @Override
            public void end(Collision of, Bodies bodies, int a, int b, double nx, double ny, double speeds) {
                of.endApproach(bodies, a, b, nx, ny, speeds);
            }
        }

        /** Separating pairs react as well. */
        final class Free implements Separation {

            @Override
            public void end(Collision of, Bodies bodies, int a, int b, double nx, double ny, double speeds) {
            }
        }
    }

    /** See {@link Collision#pushApart}. */
    sealed interface PositionalCorrection {

        void pair(Collision of, Bodies bodies, int a, int b, double nx, double ny, double distance, double time,
                  TurnSink sink);

        void fromWall(Collision of, Bodies bodies, int a, double nx, double ny, double gap, double time, TurnSink sink);

        /** Bodies stay where they are. */
        final class None implements PositionalCorrection {

            @Override
            public void pair(Collision of, Bodies bodies, int a, int b, double nx, double ny, double distance,
                             double time, TurnSink sink) {
            }

            @Override
            public void fromWall(Collision of, Bodies bodies, int a, double nx, double ny, double gap, double time,
                                 TurnSink sink) {
                of.settleAtWall(bodies, a, nx, ny, gap);
            }
        }

        /** Those that overlap are pushed apart, and a little more. */
        final class Split implements PositionalCorrection {

            @Override
            public void pair(Collision of, Bodies bodies, int a, int b, double nx, double ny, double distance,
                             double time, TurnSink sink) {
                of.pushApart(bodies, a, b, nx, ny, distance, time, sink);
            }

            @Override
            public void fromWall(Collision of, Bodies bodies, int a, double nx, double ny, double gap, double time,
                                 TurnSink sink) {
                of.pushFromWall(bodies, a, nx, ny, gap, time, sink);
            }
        }
    }
}
