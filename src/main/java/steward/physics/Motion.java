package steward.physics;

/**
 * What becomes of speeds and positions at the end of a turn; only the parts that a scene names do anything.
 *
 * @param drag              whether bodies lose their {@link Bodies#drag} share of speed
 * @param truncateVelocity  whether velocity components are then cut toward zero to whole numbers (-0.0 becomes 0.0)
 * @param roundPosition     whether positions become floor(x + 0.5): halves go up
 */
public record Motion(boolean drag, boolean truncateVelocity, boolean roundPosition) {

    /** Applies the named parts to every body. */
    public void endTurn(Bodies bodies) {
        if (drag) {
            slow(bodies);
        }
        if (truncateVelocity) {
            truncate(bodies.vx, bodies.size());
            truncate(bodies.vy, bodies.size());
        }
        if (roundPosition) {
            round(bodies.x, bodies.size());
            round(bodies.y, bodies.size());
        }
    }

    private static void slow(Bodies bodies) {
        for (int i = 0; i < bodies.size(); i++) {
            double keep = 1 - bodies.drag[i];
            bodies.vx[i] *= keep;
            bodies.vy[i] *= keep;
        }
    }

    private static void truncate(double[] values, int count) {
        for (int i = 0; i < count; i++) {
            double value = values[i];
            values[i] = (value < 0 ? Math.ceil(value) : Math.floor(value)) + 0.0;
        }
    }

    private static void round(double[] values, int count) {
        for (int i = 0; i < count; i++) {
            values[i] = Math.floor(values[i] + 0.5) + 0.0;
        }
    }
}
