package steward.minigame;

import steward.game.GameJson;
import steward.json.DrawingJson;
import steward.json.JsonAnswer;
import steward.json.JsonNumbers;
import steward.json.JsonObject;
import steward.physics.Bodies;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;

/** The frames of the pond. An answer is {@code {"push":{"x":1,"y":2},"message":"optional"}}. */
final class PondJson extends JsonAnswer implements GameJson {

    private static final String[] KINDS = {"hunter", "bubble", "cell", "fog"};

    private final Pond pond;
    private final String[] messages;
    private double x;
    private double y;

    PondJson(Pond pond) {
        super("push");
        this.pond = pond;
        messages = new String[pond.players()];
    }

    @Override
    public void writeSetup(JsonGenerator out, int player) {
        out.writeNumberProperty("hunter", pond.hunterId(player));
        JsonNumbers.write(out, "push", pond.settings().push());
        JsonNumbers.write(out, "radius", pond.settings().arena().radius());
    }

    @Override
    public void writeProgress(JsonGenerator out) {
        JsonObject.writeEach(out, "zones", 1, only -> DrawingJson.zone(out, pond.settings().arena().x(),
            pond.settings().arena().y(), pond.settings().arena().radius() / pond.turn(), "calm"));
        JsonNumbers.writeAll(out, "scores", pond.scores());
        JsonObject.writeAll(out, "resources", pond.players(), player -> {
            JsonNumbers.write(out, "mass", pond.scores()[player]);
            JsonNumbers.write(out, "tenths", Math.rint(10 * pond.scores()[player]));
        });
    }

    @Override
    public void writeTurn(JsonGenerator out, int player) {
        Bodies bodies = pond.bodies();
        JsonObject.writeAll(out, "bodies", bodies.size(), body -> {
            DrawingJson.motion(out, bodies, body);
            writeShape(out, body);
            JsonNumbers.write(out, "mass", bodies.mass[body]);
        });
    }

    /** Writes the fields of a body that do not change while it flies. @return its owner, or -1 */
    private int writeShape(JsonGenerator out, int body) {
        out.writeStringProperty("kind", KINDS[pond.bodies().kind[body]]);
        JsonNumbers.write(out, "radius", pond.bodies().radius[body]);
        int owner = pond.ownerOf(pond.bodies().id(body));
        if (owner >= 0) {
            out.writeNumberProperty("owner", owner);
        }
        return owner;
    }

    @Override
    public String readAnswer(int player, byte[] line, int length) {
        String wrong = command(player, read(line, length));
        messages[player] = wrong == null ? message() : null;
        return wrong;
    }

    @Override
    public String readCommand(JsonParser in, int player) {
        begin();
        return command(player, field("push", in));
    }

    private String command(int player, String wrong) {
        if (wrong == null) {
            pond.command(player, x, y);
        }
        return wrong;
    }

    @Override
    protected void begin() {
        x = Double.NaN;
        y = Double.NaN;
    }

    @Override
    protected String field(String name, JsonParser in) {
        if (in.currentToken() != JsonToken.START_OBJECT) {
            return name + ": found " + found(in) + ", expected {\"x\":..,\"y\":..}";
        }
        while (in.nextToken() == JsonToken.PROPERTY_NAME) {
            boolean first = in.currentName().equals("x");
            in.nextToken();
            x = first ? number(in) : x;
            y = first ? y : number(in);
        }
        return complete();
    }

    @Override
    protected String complete() {
        double length = Math.sqrt(x * x + y * y);
        return length <= pond.settings().push() ? null : "push: found a length of " + length + ", expected at most "
            + pond.settings().push();
    }

    @Override
    public String message(int player) {
        return messages[player];
    }

    @Override
    public void writeCommand(JsonGenerator out, int player) {
        DrawingJson.place(out, pond.pushX(player), pond.pushY(player));
    }

    @Override
    public void writeState(JsonGenerator out) {
        writeTurn(out, 0);
        JsonObject.writeEach(out, "passing", pond.bodies().passing().size(), k -> {
            out.writeStartArray();
            out.writeNumber(pond.bodies().passing().first(k));
            out.writeNumber(pond.bodies().passing().second(k));
            out.writeEndArray();
        });
    }

    @Override
    public void writeDrawing(JsonGenerator out) {
        double radius = pond.settings().arena().radius();
        DrawingJson.field(out, pond.settings().arena().x() - radius, pond.settings().arena().y() - radius, 2 * radius,
            2 * radius);
        JsonObject.writeAll(out, "bodies", pond.bodies().size(), body -> {
            out.writeNumberProperty("id", pond.bodies().id(body));
            int owner = writeShape(out, body);
            if (owner >= 0) {
                out.writeStringProperty("label", Integer.toString(owner));
            }
        });
    }
}
