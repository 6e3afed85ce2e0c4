package steward.scene;

import java.util.List;
import steward.physics.Wall;

/**
 * The playing field from (x, y) to (x + width, y + height), with its walls and bumpers.
 *
 * @param x       of its corner with the lowest coordinates, in u; 0 unless the world has its origin elsewhere
 * @param y       of the same corner, in u
 * @param width   above 0, in u
 * @param height  above 0, in u
 * @param walls   in the order of the file; a box is left, top (lowest y), right, bottom; may be empty
 * @param bumpers in the order of the file; may be empty
 */
public record Field(double x, double y, double width, double height, List<Wall> walls, List<Bumper> bumpers) {

    /** A field from (0, 0) to (width, height). */
    public Field(double width, double height, List<Wall> walls, List<Bumper> bumpers) {
        this(0, 0, width, height, walls, bumpers);
    }

    public Field {
        walls = List.copyOf(walls);
        bumpers = List.copyOf(bumpers);
    }
}
