package example;

import steward.game.GameJson;
import steward.json.DrawingJson;
import steward.json.JsonAnswer;
import steward.json.JsonNumbers;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.JsonParser;

/** All JSON of sumo. An answer is {@code {"x":3,"y":-4}}: the change of the wrestler's speed, in u per turn. */
final class SumoJson extends JsonAnswer implements GameJson {

    private final Sumo game;
    private final Sumo.Settings settings;
    private final String[] messages = new String[2];
    private double x;
    private double y;

    SumoJson(Sumo game, Sumo.Settings settings) {
        super("x", "y");
        this.game = game;
        this.settings = settings;
    }

    @Override
    public void writeSetup(JsonGenerator out, int player) {
        JsonNumbers.write(out, "ring", settings.ring());
        JsonNumbers.write(out, "push", settings.push());
    }

    @Override
    public void writeTurn(JsonGenerator out, int player) {
        out.writeArrayPropertyStart("bodies");
        for (int body = 0; body < 2; body++) {
            out.writeStartObject();
            DrawingJson.motion(out, game.bodies(), body);
            out.writeEndObject();
        }
        out.writeEndArray();
    }

    @Override
    public String readAnswer(int player, byte[] line, int length) {
        String wrong = command(player, read(line, length));
        messages[player] = wrong == null ? message() : null;
        return wrong;
    }

    @Override
    public String readCommand(JsonParser in, int player) {
        return command(player, readObject(in));
    }

    private String command(int player, String wrong) {
        if (wrong == null) {
            game.push(player, x, y);
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
        double value = number(in);
        x = name.equals("x") ? value : x;
        y = name.equals("y") ? value : y;
        return Double.isNaN(value) ? name + ": found " + found(in) + ", expected a finite number" : null;
    }

    @Override
    protected String complete() {
        double length = Math.sqrt(x * x + y * y);
        return length <= settings.push() ? null : "x and y: found " + (Double.isNaN(length) ? "not both"
            : "a length of " + length) + ", expected two numbers of a length of at most " + settings.push();
    }

    @Override
    public String message(int player) {
        return messages[player];
    }

    @Override
    public void writeCommand(JsonGenerator out, int player) {
        DrawingJson.place(out, game.pushX(player), game.pushY(player));
    }

    @Override
    public void writeState(JsonGenerator out) {
        writeTurn(out, 0);
    }

    @Override
    public void writeDrawing(JsonGenerator out) {
        DrawingJson.field(out, -settings.ring(), -settings.ring(), 2 * settings.ring(), 2 * settings.ring());
        out.writeArrayPropertyStart("zones");
        DrawingJson.zone(out, 0, 0, settings.ring(), "ring");
        out.writeEndArray();
        out.writeArrayPropertyStart("bodies");
        DrawingJson.body(out, 0, "wrestler", Sumo.RADIUS, 0, "0");
        DrawingJson.body(out, 1, "wrestler", Sumo.RADIUS, 1, "1");
        out.writeEndArray();
    }
}
