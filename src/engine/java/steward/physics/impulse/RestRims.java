package steward.physics.impulse;

import steward.physics.Arena;
import steward.physics.Bodies;
import steward.physics.Wall;

/**
 * Rims of arenas in a heap at rest ({@link Rest}): a path may end on a rim, not beyond it. The condition on the
 * velocity is that of the tangent at the end of the path, which depends on the velocity: normals are turned until they
 * fit.
 */
final class RestRims {

    /** Bound on how often the normals of a system are turned to the ends of paths. */
    static final int MOST_TURNS = 16;
    /** Paths end this share of the room inside the rim, or half of a closed gap: room for rounding. */
    private static final double MARGIN = 0x1p-40;

    private final InelasticSystem system;
    private final Wall[] walls;
    /** Of the path that was looked at: the normal where it ends, and the speed along it that ends on the rim. */
    double normalX;
    double normalY;
    double allowed;
    /** 1 if that path ends beyond the rim, -1 inside of it, 0 on it. */
    int beyond;

    RestRims(InelasticSystem system, Wall[] walls) {
        this.system = system;
        this.walls = walls;
    }

    /** True if a contact is one with a rim. */
    boolean isRim(int other) {
        return other < 0 && walls[~other] instanceof Arena;
    }

    /** Turns the contacts whose paths end beyond a rim, or not on one that holds them. @return whether there are any */
    boolean turn(Bodies bodies, double left) {
        boolean turned = false;
        for (int k = 0; k < system.size; k++) {
            if (isRim(system.b[k])) {
                look(bodies, system.a[k], ~system.b[k], left);
                if (beyond > 0 || system.held[k] && beyond < 0) {
                    system.turn(k, normalX, normalY, allowed);
                    turned = true;
                }
            }
        }
        return turned;
    }

    /** Looks at the end of the path of a body, at the velocity of the system; a body without room ends nowhere. */
    void look(Bodies bodies, int i, int w, double left) {
        Arena arena = (Arena) walls[w];
        double room = arena.radius() - bodies.radius[i];
        double x = bodies.x[i] - arena.x();
        double y = bodies.y[i] - arena.y();
        double endX = x + system.vx[i] * left;
        double endY = y + system.vy[i] * left;
        double distance = Math.sqrt(endX * endX + endY * endY);
        double margin = Math.min(MARGIN * room, Rest.ROUNDED * bodies.radius[i] / 2);
        double off = distance - (room - margin);
        beyond = !(room > 0) ? 0 : off > margin / 2 ? 1 : off < -margin / 2 ? -1 : 0;
        normalX = distance == 0 ? 1 : endX / distance;
        normalY = distance == 0 ? 0 : endY / distance;
        allowed = (room - margin - (normalX * x + normalY * y)) / left;
    }
}
