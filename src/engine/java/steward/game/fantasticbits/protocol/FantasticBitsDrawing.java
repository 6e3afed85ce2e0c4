package steward.game.fantasticbits.protocol;

import java.util.List;
import steward.game.Drawing;
import steward.game.fantasticbits.EntityKind;
import steward.game.fantasticbits.FantasticBits;
import steward.game.fantasticbits.Pitch;
import steward.json.DrawingJson;
import steward.json.JsonObject;
import steward.json.WallJson;
import steward.physics.Bodies;
import steward.physics.Segment;
import steward.physics.Wall;
import tools.jackson.core.JsonGenerator;

/** Shapes of Fantastic Bits that do not change: the pitch, its walls with the goals left open, and the entities. */
record FantasticBitsDrawing(FantasticBits game) implements Drawing {

    /** Around the pitch, so that the goals are seen. */
    private static final double MARGIN = 500;

    private static final List<Wall> WALLS = List.of(
        wall(0, 0, Pitch.WIDTH, 0), wall(0, Pitch.HEIGHT, Pitch.WIDTH, Pitch.HEIGHT),
        wall(0, 0, 0, Pitch.MOUTH_TOP), wall(0, Pitch.MOUTH_BOTTOM, 0, Pitch.HEIGHT),
        wall(Pitch.WIDTH, 0, Pitch.WIDTH, Pitch.MOUTH_TOP),
        wall(Pitch.WIDTH, Pitch.MOUTH_BOTTOM, Pitch.WIDTH, Pitch.HEIGHT));

    private static Wall wall(double ax, double ay, double bx, double by) {
        return new Segment(ax, ay, bx, by, 1);
    }

    @Override
    public void write(JsonGenerator out) {
        DrawingJson.field(out, -MARGIN, -MARGIN, Pitch.WIDTH + 2 * MARGIN, Pitch.HEIGHT + 2 * MARGIN);
        WallJson.write(out, WALLS);
        Bodies bodies = game.bodies();
        JsonObject.writeEach(out, "bodies", bodies.size(), k -> {
            EntityKind kind = game.pitch().kind(k);
            switch (kind) {
                case POST -> DrawingJson.fixedBody(out, bodies, k, kind.text());
                case WIZARD -> DrawingJson.body(out, bodies.id(k), kind.text(), bodies.radius[k], Pitch.playerOf(k),
                    Integer.toString(k));
                default -> DrawingJson.freeBody(out, bodies.id(k), kind.text(), bodies.radius[k]);
            }
        });
    }
}
