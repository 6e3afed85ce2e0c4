package steward.physics;

/**
 * Constant accelerations of bodies of finite mass, in u per turn^2: a force over the mass, and a gravity that is the
 * same for all. They are applied to bodies at the start of a turn ({@link #accelerate}), before it is advanced. A turn
 * is flown straight, at the speed of the middle of its parabola: at the fraction s of a turn the speed is v + a (s -
 * 1/2). Impacts are computed from this speed, in all laws but those with batches.
 *
 * @param forceX   to the right, in pod masses times u per turn^2
 * @param forceY   downwards
 * @param gravityX to the right
 * @param gravityY downwards
 */
public record Forces(double forceX, double forceY, double gravityX, double gravityY) {

    public static final Forces NONE = new Forces(0, 0, 0, 0);

    /** @throws IllegalArgumentException unless all are finite */
    public Forces {
        double sum = Math.abs(forceX) + Math.abs(forceY) + Math.abs(gravityX) + Math.abs(gravityY);
        if (!(sum < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException("forces: " + forceX + " " + forceY + " " + gravityX + " " + gravityY
                + ", expected finite numbers");
        }
    }

    /** True if any body is accelerated. */
    public boolean act() {
        return forceX != 0 || forceY != 0 || gravityX != 0 || gravityY != 0;
    }

    /** The acceleration of a body to the right; 0 for an infinite mass. */
    public double x(Bodies bodies, int i) {
        return bodies.inverseMass[i] > 0 ? forceX * bodies.inverseMass[i] + gravityX : 0;
    }

    /** The acceleration of a body downwards; 0 for an infinite mass. */
    public double y(Bodies bodies, int i) {
        return bodies.inverseMass[i] > 0 ? forceY * bodies.inverseMass[i] + gravityY : 0;
    }

    /** Changes the velocity of a body by its acceleration during a turn, and by an impulse of its own before it. */
    public void accelerate(Bodies bodies, int i, double impulseX, double impulseY) {
        if (bodies.inverseMass[i] > 0) {
            bodies.vx[i] += (forceX + impulseX) * bodies.inverseMass[i] + gravityX;
            bodies.vy[i] += (forceY + impulseY) * bodies.inverseMass[i] + gravityY;
        }
    }
}
