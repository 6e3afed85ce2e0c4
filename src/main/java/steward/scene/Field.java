package steward.scene;

import java.util.List;
import steward.physics.Wall;

/**
 * The field from (0, 0) to (width, height) with its walls and bumpers.
 *
 * @param width   above 0, in u
 * @param height  above 0, in u
 * @param walls   in the order of the file; a box is left, top (y = 0), right, bottom; may be empty
 * @param bumpers in the order of the file; may be empty
 */
public record Field(double width, double height, List<Wall> walls, List<Bumper> bumpers) {

    /** Copies the lists. */
    public Field {
        walls = List.copyOf(walls);
        bumpers = List.copyOf(bumpers);
    }
}
