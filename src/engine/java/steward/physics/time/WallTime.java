package steward.physics.time;

import steward.physics.Bodies;
import steward.physics.Wall;

/** Time of the next impact of a body with a wall. */
public abstract sealed class WallTime permits WallTime.Plain, ExactWalls {

    /** Time from now; 0 for an impact now, infinite for none. */
    public abstract double until(Bodies bodies, int i, int w);

    /** Computed by {@link TimeOfImpact#wall}. */
    public static final class Plain extends WallTime {

        private final Wall[] walls;

        public Plain(Wall[] walls) {
            this.walls = walls;
        }

        @Override
        public double until(Bodies bodies, int i, int w) {
            return TimeOfImpact.wall(walls[w], bodies.x[i], bodies.y[i], bodies.vx[i], bodies.vy[i],
                bodies.radius[i]);
        }
    }
}
