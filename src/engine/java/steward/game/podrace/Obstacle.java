package steward.game.podrace;

import java.util.ArrayList;
import java.util.List;
import steward.physics.Wall;
import steward.scene.Bumper;
import steward.scene.Field;

/**
 * Wall or bumper that a pod cannot overlap at its start.
 *
 * @param name for people, as in {@code field.bumpers[1]}
 * @param gap  from the edge of a circle to it
 */
record Obstacle(String name, Gap gap) {

    static final String EDGE = "the edge of the field";
    private static final List<String> SIDES = List.of("the left wall", "the top wall", "the right wall",
        "the bottom wall");

    /** The distance from a circle's edge to an obstacle, in u; below 0 by the depth of an overlap. */
    @FunctionalInterface
    interface Gap {
        double of(double x, double y, double radius);
    }

    /** @param box whether the walls are the four sides of a box */
    static List<Obstacle> of(Field field, boolean box) {
        List<Obstacle> obstacles = new ArrayList<>();
        for (int k = 0; k < field.walls().size(); k++) {
            Wall wall = field.walls().get(k);
            obstacles.add(new Obstacle(box ? SIDES.get(k) : "field.walls[" + k + "]", wall::gap));
        }
        for (int k = 0; k < field.bumpers().size(); k++) {
            Bumper bumper = field.bumpers().get(k);
            obstacles.add(new Obstacle("field.bumpers[" + k + "]", (x, y, radius) -> {
                double dx = x - bumper.x();
                double dy = y - bumper.y();
                return Math.sqrt(dx * dx + dy * dy) - bumper.radius() - radius;
            }));
        }
        return obstacles;
    }

    /** The edge of the field for the centre of a pod: below 0 outside. */
    static Obstacle edge(Field field) {
        return new Obstacle(EDGE, (x, y, radius) ->
            Math.min(Math.min(x - field.x(), field.x() + field.width() - x),
                Math.min(y - field.y(), field.y() + field.height() - y)));
    }
}
