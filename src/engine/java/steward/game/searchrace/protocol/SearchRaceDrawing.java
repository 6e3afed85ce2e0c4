package steward.game.searchrace.protocol;

import steward.game.Drawing;
import steward.game.searchrace.SearchRace;
import steward.json.DrawingJson;
import steward.json.JsonObject;
import tools.jackson.core.JsonGenerator;

/** Shapes of a search race: the field, the checkpoints, and the car, which is a point and gets the size of a mark. */
record SearchRaceDrawing(SearchRace race) implements Drawing {

    private static final double WIDTH = 16_000;
    private static final double HEIGHT = 9000;
    private static final double MARK = 250;

    @Override
    public void write(JsonGenerator out) {
        double left = 0;
        double top = 0;
        double right = WIDTH;
        double bottom = HEIGHT;
        double[][] checkpoints = race.checkpoints();
        for (double[] checkpoint : checkpoints) {
            left = Math.min(left, checkpoint[0]);
            top = Math.min(top, checkpoint[1]);
            right = Math.max(right, checkpoint[0]);
            bottom = Math.max(bottom, checkpoint[1]);
        }
        DrawingJson.field(out, left, top, right - left, bottom - top);
        JsonObject.writeEach(out, "zones", checkpoints.length, k ->
            DrawingJson.zone(out, checkpoints[k][0], checkpoints[k][1], race.settings().checkpointRadius(),
                Integer.toString(k)));
        out.writeArrayPropertyStart("bodies");
        DrawingJson.body(out, race.bodies().id(0), "car", MARK, 0, "");
        out.writeEndArray();
    }
}
