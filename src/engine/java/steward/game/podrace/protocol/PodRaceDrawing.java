package steward.game.podrace.protocol;

import steward.game.Drawing;
import steward.game.podrace.PodRace;
import steward.json.DrawingJson;
import steward.json.JsonObject;
import steward.json.WallJson;
import steward.physics.Bodies;
import steward.scene.Field;
import steward.scene.Scene;
import tools.jackson.core.JsonGenerator;

/**
 * Shapes of a pod race: field, walls, checkpoints, pods and bumpers.
 *
 * @param scene what it was made from
 */
record PodRaceDrawing(PodRace race, Scene scene) implements Drawing {

    @Override
    public void write(JsonGenerator out) {
        double[] frame = frame();
        DrawingJson.field(out, frame[0], frame[1], frame[2], frame[3]);
        scene.field().ifPresent(field -> WallJson.write(out, field.walls()));
        double[][] checkpoints = race.checkpoints();
        JsonObject.writeEach(out, "zones", checkpoints.length, k -> DrawingJson.zone(out, checkpoints[k][0],
            checkpoints[k][1], race.settings().checkpointRadius(), Integer.toString(k)));
        Bodies bodies = race.bodies();
        JsonObject.writeEach(out, "bodies", bodies.size(), body -> {
            if (body < race.settings().pods()) {
                DrawingJson.body(out, bodies.id(body), "pod", bodies.radius[body], race.playerOf(body),
                    Integer.toString(body));
            } else {
                DrawingJson.fixedBody(out, bodies, body, "bumper");
            }
        });
    }

    /** The area to draw: the scene's field, or the official 16000 x 9000, enlarged to contain every checkpoint. */
    private double[] frame() {
        if (scene.field().isPresent()) {
            Field field = scene.field().get();
            return new double[] {field.x(), field.y(), field.width(), field.height()};
        }
        double right = 16000;
        double bottom = 9000;
        double left = 0;
        double top = 0;
        for (double[] checkpoint : race.checkpoints()) {
            left = Math.min(left, checkpoint[0]);
            top = Math.min(top, checkpoint[1]);
            right = Math.max(right, checkpoint[0]);
            bottom = Math.max(bottom, checkpoint[1]);
        }
        return new double[] {left, top, right - left, bottom - top};
    }
}
