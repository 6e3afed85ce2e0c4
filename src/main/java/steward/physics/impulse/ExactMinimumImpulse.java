package steward.physics.impulse;

import steward.numerics.DoubleDouble;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;
import steward.physics.Wall;
import steward.physics.time.ExactPairs;
import steward.physics.time.ExactWalls;
import steward.physics.time.LowParts;

/**
 * The reactions of {@link ExactCollision} for laws with a minimum impulse, where the velocities follow from the
 * impulse.
 */
sealed class ExactMinimumImpulse extends ExactCollision {

    private final DoubleDouble first = new DoubleDouble();
    private final DoubleDouble second = new DoubleDouble();

    ExactMinimumImpulse(ImpactLaw law, Wall[] walls, ExactPairs pairs, ExactWalls wallTimes, LowParts lows) {
        super(law, walls, pairs, wallTimes, lows);
    }

    /** Computes the impulse under the law and applies it. */
    @Override
    void exchangeImpulse(Bodies bodies, int a, int b, double restitution) {
        double massA = bodies.mass[a];
        double massB = bodies.mass[b];
        multiply(high, low, length, lengthLow);
        boolean finite = massA < Double.POSITIVE_INFINITY;
        multiplyByMassShare(finite ? massB : massA, finite ? massA : massB, high, low);
        timesMass(finite ? massA : massB);
        sumSteps(pairImpulse, restitution, bodies.inverseMass[a] + bodies.inverseMass[b]);
        divide(work.high(), work.low(), length, lengthLow);
        double size = high;
        double sizeLow = low;
        applyImpulse(bodies, a, -size, -sizeLow);
        applyImpulse(bodies, b, size, sizeLow);
    }

    /** Computes the impulse from the first step and leaves it in {@code work}. */
    final void sumSteps(Impulse law, double restitution, double inverse) {
        first.setFastSum(high, low);
        law.toSecondStep(second.set(first), restitution);
        impulse = work.set(first).add(second).high();
        energy = inverse * other.set(second).subtract(first).high() * (second.high() + first.high()) / 2;
    }

    /** Multiplies the last result by a mass; most masses are 1. */
    private void timesMass(double mass) {
        if (mass != 1) {
            multiply(high, low, mass, 0);
        }
    }

    private void applyImpulse(Bodies bodies, int body, double size, double sizeLow) {
        double mass = bodies.mass[body];
        if (mass == 1) {
            addVelocity(bodies, body, size, sizeLow, dx, dxLow, dy, dyLow);
        } else if (mass < Double.POSITIVE_INFINITY) {
            divide(size, sizeLow, mass, 0);
            addVelocity(bodies, body, high, low, dx, dxLow, dy, dyLow);
        }
    }

    /** For laws whose minimum impulse also holds at walls. */
    static final class WallsIncluded extends ExactMinimumImpulse {

        WallsIncluded(ImpactLaw law, Wall[] walls, ExactPairs pairs, ExactWalls wallTimes, LowParts lows) {
            super(law, walls, pairs, wallTimes, lows);
        }

        @Override
        void exchangeImpulseWithWall(Bodies bodies, int a, double restitution) {
            double mass = bodies.mass[a];
            multiply(high, low, mass, 0);
            sumSteps(wallImpulse, restitution, bodies.inverseMass[a]);
            divide(work.high(), work.low(), mass, 0);
            applyAlongNormal(bodies, a);
        }
    }
}
