package steward.physics.impulse;

import steward.physics.Bodies;
import steward.physics.Forces;
import steward.physics.PhysicsParts;

/*
 * A turn is flown straight at the speed v of the middle of its parabola, which at the fraction s is v + a (s - 1/2). An
 * impact there is computed from these speeds; after it w = v' + a (s - 1/2), so v' = w - a (s - 1/2). Between an impact
 * at height 0 and the end of the turn the chord of v' is a s (1 - s) / 2 above that of the parabola, and at the impact
 * the parabola was as much above the chord: an elastic bounce on a level wall keeps the energy (v + a/2)^2 / 2 - a x at
 * the ends of turns.
 *
 * A body that its support carries lies exactly where its parabola is. Lifted off it at s, at the speed w, it has the
 * energy w^2 / 2 there; the chord of v' = w - a (s - 1/2) would end with a^2 s (1 - s) / 2 more, by which it is above
 * the parabola. So it leaves at (w^2 - a^2 s (1 - s))^(1/2), which exists: a hop of more than a turn has w > a / 2.
 * Otherwise a pile that bounces in itself would gain a part of a^2 / 8 with every hop, and boil for ever.
 *
 * If v' still approaches, the hop is shorter than what is left of the turn. An elastic body has it if its energy above
 * the wall is below a^2 / 8: w^2 / 2 + a^2 s (1 - s) / 2 with w < a (1/2 - s) is less than that.
 */

/** Accelerations of bodies in a turn by the scene's {@link Forces}, less the support of bodies at rest. */
public final class Accelerations {

    final Forces forces;
    double[] x = new double[0];
    double[] y = new double[0];

    private Accelerations(Forces forces) {
        this.forces = forces;
    }

    /** @return {@code null} where no force acts */
    public static Accelerations of(PhysicsParts parts) {
        return parts.forces().act() ? new Accelerations(parts.forces()) : null;
    }

    /** Begins a turn, or begins anew after bodies were removed or added. */
    public void begin(Bodies bodies) {
        if (x.length < bodies.size()) {
            x = new double[bodies.capacity()];
            y = new double[bodies.capacity()];
        }
        for (int i = 0; i < bodies.size(); i++) {
            x[i] = forces.x(bodies, i);
            y[i] = forces.y(bodies, i);
        }
    }

    /** Adds the acceleration during a part of a turn to a velocity. */
    void add(Bodies bodies, int i, double turns) {
        bodies.vx[i] += x[i] * turns;
        bodies.vy[i] += y[i] * turns;
    }

    /**
     * Returns a body from the instant of an impact to its flight. One that an impulse has lifted off its support, for
     * more than a turn, is accelerated by the whole force again, and keeps the energy that it has at the instant.
     *
     * @param vx with vy, velocity before the impact
     */
    void leave(Bodies bodies, int i, double half, double vx, double vy) {
        double heldX = forces.x(bodies, i) - x[i];
        double heldY = forces.y(bodies, i) - y[i];
        double held = heldX * heldX + heldY * heldY;
        double lifted = heldX * (vx - bodies.vx[i]) + heldY * (vy - bodies.vy[i]);
        if (2 * lifted > held) {
            double left = lifted * lifted - held * held * (0.25 - half * half);
            double share = (lifted - Math.sqrt(Math.max(0, left))) / held;
            bodies.vx[i] += heldX * share;
            bodies.vy[i] += heldY * share;
            x[i] += heldX;
            y[i] += heldY;
        }
        add(bodies, i, -half);
    }

    /** The larger magnitude of the forces' accelerations of two bodies, or of one at a wall. */
    double largest(Bodies bodies, int a, int b) {
        double ofA = magnitude(bodies, a);
        return b < 0 ? ofA : Math.max(ofA, magnitude(bodies, b));
    }

    private double magnitude(Bodies bodies, int i) {
        double ax = forces.x(bodies, i);
        double ay = forces.y(bodies, i);
        return Math.sqrt(ax * ax + ay * ay);
    }
}
