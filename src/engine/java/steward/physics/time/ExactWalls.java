package steward.physics.time;

import steward.numerics.DoubleDouble;
import steward.physics.Bodies;
import steward.physics.Wall;

/**
 * Times of impact with walls for the arithmetic {@code EXACT}: lower bounds for the search, and times in double-double
 * for those that may be next. {@link ExactWall} says what is exact.
 */
public final class ExactWalls extends WallTime {

    private final ExactWall[] walls;

    public ExactWalls(Wall[] of) {
        walls = new ExactWall[of.length];
        for (int w = 0; w < of.length; w++) {
            walls[w] = ExactWall.of(of[w]);
        }
    }

    /** @return a lower bound of the time, at least 0; infinite only if there is no impact */
    @Override
    public double until(Bodies bodies, int i, int w) {
        return walls[w].lowerBound(bodies.x[i], bodies.y[i], bodies.vx[i], bodies.vy[i], bodies.radius[i]);
    }

    /** The time of impact from now. @return false if there is none */
    public boolean exactTime(Bodies bodies, int i, int w, DoubleDouble until) {
        return walls[w].time(bodies.x[i], bodies.y[i], bodies.vx[i], bodies.vy[i], bodies.radius[i], until);
    }

    /** The lower bound for a circle that is not in {@link Bodies}. */
    public double until(int w, double x, double y, double vx, double vy, double radius) {
        return walls[w].lowerBound(x, y, vx, vy, radius);
    }

    /** The time of impact of such a circle. @return false if there is none */
    public boolean exactTime(int w, double x, double y, double vx, double vy, double radius, DoubleDouble until) {
        return walls[w].time(x, y, vx, vy, radius, until);
    }

    /** True if a body approaches a wall, by exact signs. */
    public boolean areApproaching(Bodies bodies, int i, int w) {
        return walls[w].approaches(bodies.x[i], bodies.y[i], bodies.vx[i], bodies.vy[i], bodies.radius[i]);
    }

    /** The unit vector from a point to the nearest point of a wall. */
    public void normal(int w, DoubleDouble x, DoubleDouble y, DoubleDouble normalX, DoubleDouble normalY) {
        walls[w].normal(x, y, normalX, normalY);
    }
}
