package steward.json;

import steward.physics.Bodies;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.io.SerializedString;

/** Writer of the shapes of drawings and states as JSON, for all games; {@link WallJson} writes walls. */
public final class DrawingJson {

    private static final SerializedString ID = new SerializedString("id");
    private static final SerializedString X = new SerializedString("x");
    private static final SerializedString Y = new SerializedString("y");
    private static final SerializedString VX = new SerializedString("vx");
    private static final SerializedString VY = new SerializedString("vy");

    private DrawingJson() { }

    /** The field {@code field}: the rectangle that is shown. */
    public static void field(JsonGenerator out, double x, double y, double width, double height) {
        out.writeObjectPropertyStart("field");
        JsonNumbers.write(out, "x", x);
        JsonNumbers.write(out, "y", y);
        JsonNumbers.write(out, "width", width);
        JsonNumbers.write(out, "height", height);
        out.writeEndObject();
    }

    /** The field {@code field}: so wide and high from the origin, enlarged to contain every checkpoint. */
    public static void course(JsonGenerator out, double width, double height, double[]... checkpoints) {
        double left = 0;
        double top = 0;
        double right = width;
        double bottom = height;
        for (double[] checkpoint : checkpoints) {
            left = Math.min(left, checkpoint[0]);
            top = Math.min(top, checkpoint[1]);
            right = Math.max(right, checkpoint[0]);
            bottom = Math.max(bottom, checkpoint[1]);
        }
        field(out, left, top, right - left, bottom - top);
    }

    /** The field {@code zones}: checkpoints with their numbers. */
    public static void checkpoints(JsonGenerator out, double[][] checkpoints, double radius) {
        JsonObject.writeEach(out, "zones", checkpoints.length,
            k -> zone(out, checkpoints[k][0], checkpoints[k][1], radius, Integer.toString(k)));
    }

    /** A place as an object, {@code {"x":..,"y":..}}. */
    public static void place(JsonGenerator out, double x, double y) {
        out.writeStartObject();
        JsonNumbers.write(out, "x", x);
        JsonNumbers.write(out, "y", y);
        out.writeEndObject();
    }

    /** One of the {@code zones}: a circle that bodies pass over. */
    public static void zone(JsonGenerator out, double x, double y, double radius, String label) {
        out.writeStartObject();
        JsonNumbers.write(out, "x", x);
        JsonNumbers.write(out, "y", y);
        JsonNumbers.write(out, "radius", radius);
        out.writeStringProperty("label", label);
        out.writeEndObject();
    }

    /** One of the {@code bodies} of a drawing that has an owner and can move: its places are in the states. */
    public static void body(JsonGenerator out, int id, String kind, double radius, int owner, String label) {
        out.writeStartObject();
        out.writeNumberProperty("id", id);
        out.writeStringProperty("kind", kind);
        JsonNumbers.write(out, "radius", radius);
        out.writeNumberProperty("owner", owner);
        out.writeStringProperty("label", label);
        out.writeEndObject();
    }

    /** One of the {@code bodies} of a drawing that belongs to no player and can move: its places are in the states. */
    public static void freeBody(JsonGenerator out, int id, String kind, double radius) {
        out.writeStartObject();
        out.writeNumberProperty("id", id);
        out.writeStringProperty("kind", kind);
        JsonNumbers.write(out, "radius", radius);
        out.writeEndObject();
    }

    /** One of the {@code bodies} of a drawing that never moves and belongs to no player. */
    public static void fixedBody(JsonGenerator out, Bodies bodies, int body, String kind) {
        out.writeStartObject();
        out.writeNumberProperty("id", bodies.id(body));
        out.writeStringProperty("kind", kind);
        JsonNumbers.write(out, "radius", bodies.radius[body]);
        JsonNumbers.write(out, "x", bodies.x[body]);
        JsonNumbers.write(out, "y", bodies.y[body]);
        out.writeEndObject();
    }

    /** The fields {@code id}, {@code x}, {@code y}, {@code vx}, {@code vy} of one of the {@code bodies} of a state. */
    public static void motion(JsonGenerator out, Bodies bodies, int body) {
        JsonNumbers.write(out, ID, bodies.id(body));
        flight(out, bodies, body);
    }

    /** The fields {@code x}, {@code y}, {@code vx}, {@code vy} of a body. */
    public static void flight(JsonGenerator out, Bodies bodies, int body) {
        JsonNumbers.write(out, X, bodies.x[body]);
        JsonNumbers.write(out, Y, bodies.y[body]);
        JsonNumbers.write(out, VX, bodies.vx[body]);
        JsonNumbers.write(out, VY, bodies.vy[body]);
    }
}
