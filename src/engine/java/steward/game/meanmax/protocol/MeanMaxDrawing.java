package steward.game.meanmax.protocol;

import steward.game.Drawing;
import steward.game.meanmax.MeanMax;
import steward.game.meanmax.MeanMaxWorld;
import steward.game.meanmax.UnitKind;
import steward.json.DrawingJson;
import steward.json.JsonObject;
import steward.physics.Bodies;
import tools.jackson.core.JsonGenerator;

/** Shapes of Mean Max that do not change: the area to show, the arena, where tankers fill, and the looters. */
record MeanMaxDrawing(MeanMax game) implements Drawing {

    /** Around the arena tankers come and go. */
    private static final double MARGIN = 2000;

    @Override
    public void write(JsonGenerator out) {
        double side = MeanMaxWorld.ARENA_RADIUS + MARGIN;
        DrawingJson.field(out, -side, -side, 2 * side, 2 * side);
        out.writeArrayPropertyStart("zones");
        DrawingJson.zone(out, 0, 0, MeanMaxWorld.ARENA_RADIUS, "arena");
        DrawingJson.zone(out, 0, 0, MeanMaxWorld.WATER_RADIUS, "water");
        out.writeEndArray();
        Bodies bodies = game.bodies();
        JsonObject.writeEach(out, "bodies", game.players() * game.settings().looters(), unit -> {
            String kind = UnitKind.of(bodies.kind[unit]).text();
            DrawingJson.body(out, bodies.id(unit), kind, bodies.radius[unit], game.playerOf(bodies.id(unit)),
                kind.substring(0, 2));
        });
    }
}
