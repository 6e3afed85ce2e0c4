package steward.physics.impulse;

import steward.physics.Bodies;
import steward.physics.time.CompensatedCircles;

/**
 * Impulses with their rounding errors added back, for laws without a minimum impulse. So the energy of a gas of elastic
 * discs is affected only by the rounding of stored velocities, which does not drift; and an elastic bounce off a
 * vertical or horizontal wall exactly negates a velocity component. Impulse and energy for the record are plain.
 */
final class CompensatedSolver extends PlainSolver {

    /** For the arithmetic {@code COMPENSATED}, whose search sees approach that plain doubles do not see. */
    private final boolean judges;
    private final PlainSolver plain = new PlainSolver();
    private final ImpulseRegister q = new ImpulseRegister();

    /** @param judges whether a residual approach is removed until {@link CompensatedCircles} sees none */
    CompensatedSolver(boolean judges) {
        this.judges = judges;
    }

    @Override
    void apply(Bodies bodies, int a, int b, double nx, double ny, double restitution, double impulse) {
        q.project(bodies.vx[a], bodies.vx[b], bodies.vy[a], bodies.vy[b], nx, 0, ny, 0);
        q.multiplyByOnePlus(restitution);
        double size = q.high;
        double sizeLow = q.low;
        q.multiplyByMassShare(bodies.mass[b], bodies.mass[a], size, sizeLow);
        ImpulseRegister.addVelocity(bodies, a, -q.high, -q.low, nx, 0, ny, 0);
        q.multiplyByMassShare(bodies.mass[a], bodies.mass[b], size, sizeLow);
        ImpulseRegister.addVelocity(bodies, b, q.high, q.low, nx, 0, ny, 0);
    }

    @Override
    void applyAtWall(Bodies bodies, int a, double nx, double ny, double restitution, double impulse) {
        q.project(bodies.vx[a], 0, bodies.vy[a], 0, nx, 0, ny, 0);
        q.multiplyByOnePlus(restitution);
        ImpulseRegister.addVelocity(bodies, a, -q.high, -q.low, nx, 0, ny, 0);
    }

    @Override
    boolean areApproaching(Bodies bodies, int a, int b) {
        return judges ? CompensatedCircles.areApproaching(bodies, a, b) : super.areApproaching(bodies, a, b);
    }

    @Override
    void separate(Bodies bodies, int a, int b, double x, double y, double speeds) {
        plain.separate(bodies, a, b, x, y, speeds);
        if (judges) {
            super.separate(bodies, a, b, x, y, speeds);
        }
    }
}
