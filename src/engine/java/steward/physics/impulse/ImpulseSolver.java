package steward.physics.impulse;

import steward.physics.Bodies;
import steward.physics.Wall;

/**
 * Solver for impulses in one arithmetic, and for everything at an impact that depends on signs and roundings. The order
 * of steps and the record belong to the law: {@link Collision}. One instance serves one thread; a result belongs to the
 * last call.
 */
abstract sealed class ImpulseSolver permits PlainSolver, ExactSolver {

    /** Computes the impulse of a pair and applies it to the velocities. */
    abstract void exchange(Bodies bodies, int a, int b, double restitution, Impulse rule, SolvedImpulse solved);

    /**
     * Computes the impulse of a body and a wall and applies it. @return false if they do not approach: then only the
     * normal is set
     */
    abstract boolean exchangeWithWall(Bodies bodies, int a, int w, Wall wall, double restitution, Impulse rule,
                                      SolvedImpulse solved);

    /** True if a pair approaches, as the search for impacts judges it. */
    abstract boolean areApproaching(Bodies bodies, int a, int b);

    /** True if a body touches a wall and approaches it, as the search for impacts judges it. */
    abstract boolean isPressed(Bodies bodies, int a, int w, Wall wall);

    /** The overlap of a pair after its impulse; 0 in contact, negative if they do not touch. */
    abstract double overlap(Bodies bodies, int a, int b, SolvedImpulse solved);

    /** Moves a body along the normal of the last impulse, of which a pair's {@link #overlap} has been asked. */
    abstract void moveAlongNormal(Bodies bodies, int body, double by, SolvedImpulse solved);

    /** True if positions are known beyond their rounding, so that contact at a wall is not lost by rounding. */
    boolean keepsRounding() {
        return false;
    }

    /** Takes the position of a body as it is stored. */
    void forgetRounding(int body) {
        // here positions are as stored
    }

    /*
     * Rounding can leave a residual approach after an impulse that should have ended it (restitution 0 or nearly 0).
     * Where only approach reacts, the pair would react again and again at the same instant, each impulse too small to
     * change a digit of a velocity, until the bound on impacts. So the residual approach is removed in steps that
     * double, starting from one unit in the last place of the speeds: an error as large as that of storing them.
     */

    /**
     * Removes a residual approach of a pair.
     *
     * @param x      with y, a direction from a to b, no longer than 1
     * @param speeds sum of the velocity components of both before the impact, in magnitude: sets the first step
     */
    void separate(Bodies bodies, int a, int b, double x, double y, double speeds) {
        boolean first = bodies.inverseMass[a] >= bodies.inverseMass[b];
        int body = first ? a : b;
        double step = first ? -Math.ulp(speeds) : Math.ulp(speeds);
        while (areApproaching(bodies, a, b)) {
            bodies.vx[body] += x * step;
            bodies.vy[body] += y * step;
            step *= 2;
        }
    }
}
