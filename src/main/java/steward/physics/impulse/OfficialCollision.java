package steward.physics.impulse;

import steward.physics.Bodies;
import steward.physics.ImpactLaw;
import steward.physics.Wall;

/**
 * The reactions of {@link Collision} with the published official referee's own change of velocity: the impulse times
 * the double 1/m, where a division by m would round once and not twice. With masses 1 and 10 the two differ in the last
 * digits; official turns of 2026, in which a body of mass 10 has an impact and then another in the same turn, show the
 * product.
 */
final class OfficialCollision extends Collision {

    OfficialCollision(ImpactLaw law, Wall[] walls) {
        super(law, walls);
    }

    @Override
    void applyPairImpulse(Bodies bodies, int a, int b, double nx, double ny, double restitution, double impulse) {
        double inverseA = bodies.inverseMass[a];
        double inverseB = bodies.inverseMass[b];
        bodies.vx[a] -= nx * impulse * inverseA;
        bodies.vy[a] -= ny * impulse * inverseA;
        bodies.vx[b] += nx * impulse * inverseB;
        bodies.vy[b] += ny * impulse * inverseB;
    }
}
