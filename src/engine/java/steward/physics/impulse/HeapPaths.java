package steward.physics.impulse;

import steward.physics.Bodies;
import steward.physics.Wall;

/** Paths of a heap's bodies at the velocities of its system ({@link Rest}): which of them meet within a time. */
final class HeapPaths {

    private final InelasticSystem system;
    private final RestImpulses impulses;

    HeapPaths(InelasticSystem system, RestImpulses impulses) {
        this.system = system;
        this.impulses = impulses;
    }

    /** True if two bodies would meet in a time, on straight paths. */
    boolean meet(Bodies bodies, int i, int j, double left) {
        double dx = bodies.x[j] - bodies.x[i];
        double dy = bodies.y[j] - bodies.y[i];
        double ux = system.vx[j] - system.vx[i];
        double uy = system.vy[j] - system.vy[i];
        double closing = -(dx * ux + dy * uy);
        double reach = bodies.radius[i] + bodies.radius[j];
        double distance = Math.sqrt(dx * dx + dy * dy);
        double apart = distance - reach;
        if (left == 0) {
            return apart <= Rest.CLOSED * reach && closing > impulses.tolerance() * distance;
        }
        if (!(closing > impulses.tolerance() * distance) || closing * left <= apart * distance) {
            return false;
        }
        double nearest = Math.min(left, closing / (ux * ux + uy * uy));
        double x = dx + ux * nearest;
        double y = dy + uy * nearest;
        return apart <= 0 || x * x + y * y < reach * reach;
    }

    /** True if a body would meet a wall in a time. */
    boolean meetWall(Bodies bodies, int i, Wall wall, double left) {
        double x = bodies.x[i];
        double y = bodies.y[i];
        double closing = wall.normalX(x, y) * system.vx[i] + wall.normalY(x, y) * system.vy[i];
        double apart = wall.gap(x, y, bodies.radius[i]);
        if (left == 0) {
            return apart <= Rest.CLOSED * bodies.radius[i] && closing > impulses.tolerance();
        }
        return closing > impulses.tolerance() && closing * left > apart
            && (apart <= 0 || wall.gap(x + system.vx[i] * left, y + system.vy[i] * left, bodies.radius[i]) < 0);
    }

    /** A bound on the paths of bodies with a place in the heap, and of infinite masses, in a time. */
    double longest(Bodies bodies, int[] place, double left) {
        double fastest = 0;
        for (int i = 0; i < bodies.size() && left > 0; i++) {
            if (place[i] >= 0 || bodies.inverseMass[i] == 0) {
                fastest = Math.max(fastest, Math.abs(system.vx[i]) + Math.abs(system.vy[i]));
            }
        }
        return fastest * left;
    }
}
