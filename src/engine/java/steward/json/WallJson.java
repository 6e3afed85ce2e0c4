package steward.json;

import java.util.List;
import steward.physics.Arena;
import steward.physics.HalfPlane;
import steward.physics.Segment;
import steward.physics.Wall;
import tools.jackson.core.JsonGenerator;

/** Writer of a drawing's walls as JSON, in the shapes of scene files, for all games. */
public final class WallJson {

    private WallJson() { }

    /** The field {@code walls}, an array in the order of the walls' indices; nothing if there are none. */
    public static void write(JsonGenerator out, List<Wall> walls) {
        if (walls.isEmpty()) {
            return;
        }
        JsonObject.writeAll(out, "walls", walls, wall -> {
            if (wall instanceof HalfPlane plane) {
                out.writeStringProperty("type", "half-plane");
                JsonNumbers.write(out, "x", plane.x());
                JsonNumbers.write(out, "y", plane.y());
                JsonNumbers.write(out, "insideX", plane.insideX());
                JsonNumbers.write(out, "insideY", plane.insideY());
            } else if (wall instanceof Segment segment) {
                out.writeStringProperty("type", "segment");
                JsonNumbers.write(out, "ax", segment.ax());
                JsonNumbers.write(out, "ay", segment.ay());
                JsonNumbers.write(out, "bx", segment.bx());
                JsonNumbers.write(out, "by", segment.by());
            } else if (wall instanceof Arena arena) {
                out.writeStringProperty("type", "arena");
                JsonNumbers.write(out, "x", arena.x());
                JsonNumbers.write(out, "y", arena.y());
                JsonNumbers.write(out, "radius", arena.radius());
            }
        });
    }
}
