package steward.physics.impulse;

import steward.physics.Bodies;
import steward.physics.ImpactLaw;
import steward.physics.Wall;

/**
 * Restitution of an impact, 0..1, from those of its two partners.
 *
 * @param elastic whether every impact is; otherwise the lower of the two counts
 */
record RestitutionRule(boolean elastic) {

    static RestitutionRule of(ImpactLaw law) {
        return new RestitutionRule(law.restitution() == ImpactLaw.Restitution.ELASTIC);
    }

    double betweenBodies(Bodies bodies, int a, int b) {
        return elastic ? 1 : Math.min(bodies.restitution[a], bodies.restitution[b]);
    }

    double atWall(Bodies bodies, int a, Wall wall) {
        return elastic ? 1 : Math.min(bodies.restitution[a], wall.restitution());
    }
}
