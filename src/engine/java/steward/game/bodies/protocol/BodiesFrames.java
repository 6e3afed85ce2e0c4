package steward.game.bodies.protocol;

import java.util.List;
import steward.game.BotFrames;
import steward.game.Drawing;
import steward.game.bodies.BodiesGame;
import steward.game.bodies.Body;
import steward.game.bodies.Zone;
import steward.json.DrawingJson;
import steward.json.JsonNumbers;
import steward.json.JsonObject;
import steward.json.WallJson;
import steward.scene.Field;
import tools.jackson.core.JsonGenerator;

/** JSON frames that bots are sent, their answers, and the drawing. */
final class BodiesFrames implements BotFrames, Drawing {

    private final BodiesGame game;
    private final Field field;
    private final BodiesAnswer answer;
    private final String[] messages;

    BodiesFrames(BodiesGame game, Field field) {
        this.game = game;
        this.field = field;
        answer = new BodiesAnswer(game);
        messages = new String[game.players()];
    }

    @Override
    public void writeSetup(JsonGenerator out, int player) {
        out.writeNumberProperty("maximumTurns", game.rules().maximumTurns());
        JsonNumbers.write(out, "maximumThrust", game.rules().maximumThrust());
        WallJson.write(out, field.walls());
        writeZones(out, true);
        JsonObject.writeAll(out, "bodies", game.bodies().size(), k -> {
            int id = game.bodies().id(k);
            out.writeNumberProperty("id", id);
            int owner = id < game.discs().size() ? game.discs().get(id).owner() : Body.NOBODY;
            if (owner != Body.NOBODY) {
                out.writeNumberProperty("player", owner);
            }
            JsonNumbers.write(out, "radius", game.bodies().radius[k]);
            if (game.bodies().inverseMass[k] == 0) {
                out.writeStringProperty("mass", "infinite");
            } else {
                JsonNumbers.write(out, "mass", game.bodies().mass[k]);
            }
            JsonNumbers.write(out, "restitution", game.bodies().restitution[k]);
            JsonNumbers.write(out, "drag", game.bodies().drag[k]);
            if (id >= game.discs().size()) {
                JsonNumbers.write(out, "x", game.bodies().x[k]);
                JsonNumbers.write(out, "y", game.bodies().y[k]);
            }
        });
    }

    private void writeZones(JsonGenerator out, boolean rules) {
        List<Zone> zones = game.rules().zones();
        if (zones.isEmpty()) {
            return;
        }
        out.writeArrayPropertyStart("zones");
        for (Zone zone : zones) {
            if (rules) {
                out.writeStartObject();
                JsonNumbers.write(out, "x", zone.x());
                JsonNumbers.write(out, "y", zone.y());
                JsonNumbers.write(out, "radius", zone.radius());
                out.writeStringProperty("label", zone.label());
                out.writeNumberProperty("points", zone.points());
                out.writeBooleanProperty("ends", zone.ends());
                if (zone.removes()) {
                    out.writeBooleanProperty("removes", true);
                }
                if (zone.passing()) {
                    out.writeStringProperty("when", "passing");
                }
                out.writeEndObject();
            } else {
                DrawingJson.zone(out, zone.x(), zone.y(), zone.radius(), zone.label());
            }
        }
        out.writeEndArray();
    }

    @Override
    public void writeTurn(JsonGenerator out, int player) {
        BodiesState.writeScores(out, game);
        JsonObject.writeAll(out, "bodies", game.discs().size(), id -> {
            Zone taker = game.taker(id);
            if (taker == null) {
                DrawingJson.motion(out, game.bodies(), game.bodies().indexOf(id));
            } else {
                out.writeNumberProperty("id", id);
                JsonNumbers.write(out, "x", taker.x());
                JsonNumbers.write(out, "y", taker.y());
                JsonNumbers.write(out, "vx", 0);
                JsonNumbers.write(out, "vy", 0);
                out.writeBooleanProperty("out", true);
            }
        });
    }

    @Override
    public String readAnswer(int player, byte[] line, int length) {
        answer.expect(player);
        String wrong = answer.read(line, length);
        messages[player] = wrong == null ? answer.message() : null;
        int[] owned = game.owned(player);
        for (int k = 0; wrong == null && k < owned.length; k++) {
            game.thrust(owned[k], answer.command(k));
        }
        return wrong;
    }

    @Override
    public String message(int player) {
        return messages[player];
    }

    @Override
    public void write(JsonGenerator out) {
        DrawingJson.field(out, field.x(), field.y(), field.width(), field.height());
        WallJson.write(out, field.walls());
        writeZones(out, false);
        out.writeArrayPropertyStart("bodies");
        for (int k = 0; k < game.discs().size(); k++) {
            Body disc = game.discs().get(k);
            out.writeStartObject();
            out.writeNumberProperty("id", k);
            out.writeStringProperty("kind", "disc");
            JsonNumbers.write(out, "radius", disc.radius());
            if (disc.mass() < Double.POSITIVE_INFINITY) {
                JsonNumbers.write(out, "mass", disc.mass());
            }
            if (disc.owner() != Body.NOBODY) {
                out.writeNumberProperty("owner", disc.owner());
            }
            if (!disc.label().isEmpty()) {
                out.writeStringProperty("label", disc.label());
            }
            if (!disc.colour().isEmpty()) {
                out.writeStringProperty("colour", disc.colour());
            }
            out.writeEndObject();
        }
        for (int k = game.discsLeft(); k < game.bodies().size(); k++) {
            DrawingJson.fixedBody(out, game.bodies(), k, "bumper");
        }
        out.writeEndArray();
    }
}
