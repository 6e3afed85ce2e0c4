package steward.minigame.airhockey;

import steward.game.GameJson;
import steward.json.DrawingJson;
import steward.json.JsonAnswer;
import steward.json.JsonNumbers;
import steward.json.WallJson;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.JsonParser;

/** All JSON of air hockey. An answer is {@code {"x":3,"y":-4.5}}: what the speed of the paddle changes by. */
final class HockeyJson extends JsonAnswer implements GameJson {

    private final AirHockey game;
    private final HockeySettings settings;
    private final String[] messages = new String[2];
    private double x;
    private double y;

    HockeyJson(AirHockey game, HockeySettings settings) {
        super("x", "y");
        this.game = game;
        this.settings = settings;
    }

    @Override
    public void writeSetup(JsonGenerator out, int player) {
        JsonNumbers.write(out, "push", settings.push());
        JsonNumbers.write(out, "goal", settings.goal());
    }

    @Override
    public void writeTurn(JsonGenerator out, int player) {
        out.writeArrayPropertyStart("bodies");
        for (int body = 0; body < game.bodies().size(); body++) {
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
        out.writeBooleanProperty("onLine", game.isOnLine());
    }

    @Override
    public void writeProgress(JsonGenerator out) {
        out.writeArrayPropertyStart("scores");
        for (double score : game.scores()) {
            JsonNumbers.write(out, score);
        }
        out.writeEndArray();
    }

    @Override
    public void writeDrawing(JsonGenerator out) {
        DrawingJson.field(out, 0, 0, settings.field().width(), settings.field().height());
        WallJson.write(out, settings.field().walls());
        out.writeArrayPropertyStart("bodies");
        DrawingJson.body(out, 0, "paddle", AirHockey.RADIUS[0], 0, "0");
        DrawingJson.body(out, 1, "paddle", AirHockey.RADIUS[1], 1, "1");
        DrawingJson.freeBody(out, 2, "puck", AirHockey.RADIUS[2]);
        out.writeEndArray();
    }
}
