package steward.physics.impulse;

/** Result of an {@link ImpulseSolver}: the impulse that it has applied. */
final class SolvedImpulse {

    /** The unit vector from the one to the other. */
    double normalX;
    double normalY;
    /** Along the normal. */
    double impulse;
    /** The change of kinetic energy. */
    double energy;
    /** Of the two centres; not of a wall. */
    double distance;

    void setNormal(double x, double y) {
        normalX = x;
        normalY = y;
    }

    void set(double ofImpulse, double ofEnergy) {
        impulse = ofImpulse;
        energy = ofEnergy;
    }
}
