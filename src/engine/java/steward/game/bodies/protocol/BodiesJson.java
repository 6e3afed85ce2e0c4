package steward.game.bodies.protocol;

import java.util.List;
import steward.game.CommandsJson;
import steward.game.bodies.BodiesGame;
import steward.game.bodies.BodiesGame.Thrust;
import steward.game.bodies.Body;
import steward.game.bodies.Zone;
import steward.json.DrawingJson;
import steward.json.JsonNumbers;
import steward.json.JsonObject;
import steward.json.WallJson;
import steward.physics.Bodies;
import steward.scene.Field;
import tools.jackson.core.JsonGenerator;

/** JSON of the game {@code bodies}: frames, commands, states and drawing; {@link BodiesAnswer} reads answers. */
public final class BodiesJson extends CommandsJson<Thrust> {

    private final BodiesGame game;
    private final Field field;

    BodiesJson(BodiesGame game, Field field) {
        super(game.players(), new BodiesAnswer(game), new BodiesAnswer(game));
        this.game = game;
        this.field = field;
    }

    /** State of a game. @param points per player, whole ones */
    public record State(List<Disc> bodies, long[] points) { }

    /** A disc that no zone has taken out. */
    public record Disc(int id, double x, double y, double vx, double vy) { }

    @Override
    public void writeSetup(JsonGenerator out, int player) {
        out.writeNumberProperty("maximumTurns", game.rules().maximumTurns());
        JsonNumbers.write(out, "maximumThrust", game.rules().maximumThrust());
        WallJson.write(out, field.walls());
        writeZones(out, true);
        Bodies bodies = game.bodies();
        JsonObject.writeAll(out, "bodies", bodies.size(), k -> {
            int id = bodies.id(k);
            out.writeNumberProperty("id", id);
            int owner = id < game.discs().size() ? game.discs().get(id).owner() : Body.NOBODY;
            if (owner != Body.NOBODY) {
                out.writeNumberProperty("player", owner);
            }
            JsonNumbers.write(out, "radius", bodies.radius[k]);
            if (bodies.inverseMass[k] == 0) {
                out.writeStringProperty("mass", "infinite");
            } else {
                JsonNumbers.write(out, "mass", bodies.mass[k]);
            }
            JsonNumbers.write(out, "restitution", bodies.restitution[k]);
            JsonNumbers.write(out, "drag", bodies.drag[k]);
            if (id >= game.discs().size()) {
                JsonNumbers.write(out, "x", bodies.x[k]);
                JsonNumbers.write(out, "y", bodies.y[k]);
            }
        });
    }

    private void writeZones(JsonGenerator out, boolean rules) {
        List<Zone> zones = game.rules().zones();
        if (zones.isEmpty()) {
            return;
        }
        JsonObject.writeAll(out, "zones", zones, zone -> {
            JsonNumbers.write(out, "x", zone.x());
            JsonNumbers.write(out, "y", zone.y());
            JsonNumbers.write(out, "radius", zone.radius());
            out.writeStringProperty("label", zone.label());
            if (rules) {
                out.writeNumberProperty("points", zone.points());
                out.writeBooleanProperty("ends", zone.ends());
                if (zone.removes()) {
                    out.writeBooleanProperty("removes", true);
                }
                if (zone.passing()) {
                    out.writeStringProperty("when", "passing");
                }
            }
        });
    }

    @Override
    public void writeTurn(JsonGenerator out, int player) {
        JsonNumbers.writeAll(out, "scores", game.scores());
        JsonObject.writeAll(out, "bodies", game.discs().size(), id -> {
            Zone taker = game.taker(id);
            if (taker == null) {
                DrawingJson.motion(out, game.bodies(), game.bodies().indexOf(id));
                return;
            }
            out.writeNumberProperty("id", id);
            JsonNumbers.write(out, "x", taker.x());
            JsonNumbers.write(out, "y", taker.y());
            JsonNumbers.write(out, "vx", 0);
            JsonNumbers.write(out, "vy", 0);
            out.writeBooleanProperty("out", true);
        });
    }

    @Override
    public void writeState(JsonGenerator out) {
        JsonObject.writeAll(out, "bodies", game.discsLeft(), k -> DrawingJson.motion(out, game.bodies(), k));
        JsonObject.writeEach(out, "points", game.players(), player -> out.writeNumber(game.points(player)));
    }

    @Override
    public void writeProgress(JsonGenerator out) {
        if (game.players() > 0) {
            JsonNumbers.writeAll(out, "scores", game.scores());
        }
    }

    @Override
    public void writeDrawing(JsonGenerator out) {
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

    @Override
    protected int commands(int player) {
        return game.owned(player).length;
    }

    @Override
    protected Thrust command(int player, int index) {
        return game.thrust(game.owned(player)[index]);
    }

    @Override
    protected void command(int player, int index, Thrust thrust) {
        game.thrust(game.owned(player)[index], thrust);
    }

    @Override
    protected void writeFields(JsonGenerator out, Thrust thrust) {
        JsonNumbers.write(out, "x", thrust.x());
        JsonNumbers.write(out, "y", thrust.y());
    }
}
