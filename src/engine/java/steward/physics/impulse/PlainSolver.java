package steward.physics.impulse;

import steward.physics.Bodies;
import steward.physics.Wall;
import steward.physics.time.TimeOfImpact;

/** Impulses in plain doubles, with the expressions of the published official referee in their order. */
sealed class PlainSolver extends ImpulseSolver permits PlainSolver.Official, CompensatedSolver {

    @Override
    final void exchange(Bodies bodies, int a, int b, double restitution, Impulse rule, SolvedImpulse solved) {
        double dx = bodies.x[b] - bodies.x[a];
        double dy = bodies.y[b] - bodies.y[a];
        double distance = Math.sqrt(dx * dx + dy * dy);
        double nx = distance == 0 ? 1 : dx / distance;
        double ny = distance == 0 ? 0 : dy / distance;
        double inverse = bodies.inverseMass[a] + bodies.inverseMass[b];
        double first = (nx * (bodies.vx[a] - bodies.vx[b]) + ny * (bodies.vy[a] - bodies.vy[b])) / inverse;
        double second = rule.secondStep(first, restitution);
        solved.setNormal(nx, ny);
        solved.distance = distance;
        solved.set(first + second, inverse * (second * second - first * first) / 2);
        apply(bodies, a, b, nx, ny, restitution, first + second);
    }

    @Override
    final boolean exchangeWithWall(Bodies bodies, int a, int w, Wall wall, double restitution, Impulse rule,
                                   SolvedImpulse solved) {
        double nx = wall.normalX(bodies.x[a], bodies.y[a]);
        double ny = wall.normalY(bodies.x[a], bodies.y[a]);
        double inverse = bodies.inverseMass[a];
        double approach = nx * bodies.vx[a] + ny * bodies.vy[a];
        solved.setNormal(nx, ny);
        if (!(approach > 0)) {
            return false;
        }
        double first = approach / inverse;
        double second = rule.secondStep(first, restitution);
        solved.set(first + second, inverse * (second * second - first * first) / 2);
        applyAtWall(bodies, a, nx, ny, restitution, first + second);
        return true;
    }

    /** Applies an impulse along the unit vector from a to b. */
    void apply(Bodies bodies, int a, int b, double nx, double ny, double restitution, double impulse) {
        double massA = bodies.mass[a];
        double massB = bodies.mass[b];
        change(bodies, a, b, nx * impulse / massA, ny * impulse / massA, nx * impulse / massB, ny * impulse / massB);
    }

    /** Subtracts from a velocity and adds to another; reads before it writes, which is quicker. */
    private static void change(Bodies bodies, int a, int b, double ofAx, double ofAy, double ofBx, double ofBy) {
        double vax = bodies.vx[a] - ofAx;
        double vay = bodies.vy[a] - ofAy;
        double vbx = bodies.vx[b] + ofBx;
        double vby = bodies.vy[b] + ofBy;
        bodies.vx[a] = vax;
        bodies.vy[a] = vay;
        bodies.vx[b] = vbx;
        bodies.vy[b] = vby;
    }

    /** Applies an impulse against the unit vector to a wall. */
    void applyAtWall(Bodies bodies, int a, double nx, double ny, double restitution, double impulse) {
        double mass = bodies.mass[a];
        bodies.vx[a] -= nx * impulse / mass;
        bodies.vy[a] -= ny * impulse / mass;
    }

    @Override
    boolean areApproaching(Bodies bodies, int a, int b) {
        double dx = bodies.x[b] - bodies.x[a];
        double dy = bodies.y[b] - bodies.y[a];
        return dx * (bodies.vx[b] - bodies.vx[a]) + dy * (bodies.vy[b] - bodies.vy[a]) < 0;
    }

    @Override
    final boolean isPressed(Bodies bodies, int a, int w, Wall wall) {
        return TimeOfImpact.wall(wall, bodies.x[a], bodies.y[a], bodies.vx[a], bodies.vy[a], bodies.radius[a]) == 0;
    }

    @Override
    final double overlap(Bodies bodies, int a, int b, SolvedImpulse solved) {
        return bodies.radius[a] + bodies.radius[b] - solved.distance;
    }

    @Override
    final void moveAlongNormal(Bodies bodies, int body, double by, SolvedImpulse solved) {
        bodies.x[body] += solved.normalX * by;
        bodies.y[body] += solved.normalY * by;
    }

    /**
     * With the published official referee's own change of velocity: the impulse times the double 1/m, where a division
     * by m would round once and not twice. With masses 1 and 10 the two differ in the last digits; official turns of
     * 2026, in which a body of mass 10 has an impact and then another in the same turn, show the product.
     */
    static final class Official extends PlainSolver {

        @Override
        void apply(Bodies bodies, int a, int b, double nx, double ny, double restitution, double impulse) {
            double inverseA = bodies.inverseMass[a];
            double inverseB = bodies.inverseMass[b];
            change(bodies, a, b, nx * impulse * inverseA, ny * impulse * inverseA, nx * impulse * inverseB,
                ny * impulse * inverseB);
        }
    }
}
