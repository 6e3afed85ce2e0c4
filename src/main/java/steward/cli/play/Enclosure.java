package steward.cli.play;

import java.util.stream.Stream;
import steward.physics.Arena;
import steward.physics.HalfPlane;
import steward.physics.Segment;
import steward.physics.Wall;
import steward.scene.Bumper;
import steward.scene.Field;

/**
 * Length of the walls around a scene's bodies and the area between them, for the bodies' pressure.
 *
 * @param length of all that holds bodies, in u: sides of the field that are walls, arenas, both sides of segments,
 *               bumpers; NaN if a straight wall without end is none of the field's sides
 * @param area   of the field between four walls, or of the smallest arena, less the bumpers, in u^2, and not less what
 *               other straight walls cut off; NaN if the scene has neither
 */
record Enclosure(double length, double area) {

    static final Enclosure NONE = new Enclosure(Double.NaN, Double.NaN);

    static Enclosure of(Field field) {
        double length = 0;
        double area = Double.NaN;
        for (Wall wall : field.walls()) {
            if (wall instanceof Arena arena) {
                length += 2 * Math.PI * arena.radius();
                double round = Math.PI * arena.radius() * arena.radius();
                area = area < round ? area : round;
            } else if (wall instanceof Segment segment) {
                length += 2 * Math.sqrt((segment.bx() - segment.ax()) * (segment.bx() - segment.ax())
                    + (segment.by() - segment.ay()) * (segment.by() - segment.ay()));
            } else {
                length += side((HalfPlane) wall, field);
            }
        }
        if (Double.isNaN(area) && Stream.of(Wall.box(field.x(), field.y(), field.width(), field.height(), 1))
                .allMatch(side -> field.walls().stream().anyMatch(wall -> isSide((HalfPlane) side, wall)))) {
            area = field.width() * field.height();
        }
        for (Bumper bumper : field.bumpers()) {
            length += 2 * Math.PI * bumper.radius();
            area -= Math.PI * bumper.radius() * bumper.radius();
        }
        return new Enclosure(length > 0 ? length : Double.NaN, area);
    }

    private static boolean isSide(HalfPlane side, Wall wall) {
        return wall instanceof HalfPlane other && side.x() == other.x() && side.y() == other.y()
            && side.insideX() == other.insideX() && side.insideY() == other.insideY();
    }

    /** The length of a side of the field, or NaN for another straight wall. */
    private static double side(HalfPlane wall, Field field) {
        boolean left = wall.insideX() == 1 && wall.x() == field.x();
        boolean right = wall.insideX() == -1 && wall.x() == field.x() + field.width();
        boolean top = wall.insideY() == 1 && wall.y() == field.y();
        boolean bottom = wall.insideY() == -1 && wall.y() == field.y() + field.height();
        return left || right ? field.height() : top || bottom ? field.width() : Double.NaN;
    }
}
