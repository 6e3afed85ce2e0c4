package steward.guest;

import steward.game.BotFrames;
import steward.game.Drawing;
import steward.json.DrawingJson;
import steward.json.JsonObject;
import tools.jackson.core.JsonGenerator;

/** Frames in JSON and the drawing of a guest: there are none, since its bots speak lines and nothing is known of it. */
record GuestLines(GuestGame game) implements BotFrames, Drawing {

    static final int WIDTH = 1600;
    static final int HEIGHT = 900;

    @Override
    public void writeSetup(JsonGenerator out, int player) {
        throw new UnsupportedOperationException("a guest has no frames");
    }

    @Override
    public void writeTurn(JsonGenerator out, int player) {
        throw new UnsupportedOperationException("a guest has no frames");
    }

    @Override
    public String readAnswer(int player, byte[] line, int length) {
        throw new UnsupportedOperationException("a guest has no frames");
    }

    @Override
    public String message(int player) {
        return null;
    }

    /** An empty field. */
    @Override
    public void write(JsonGenerator out) {
        DrawingJson.field(out, 0, 0, WIDTH, HEIGHT);
        JsonObject.writeAll(out, "walls", 0, k -> { });
        JsonObject.writeAll(out, "zones", 0, k -> { });
        JsonObject.writeAll(out, "bodies", 0, k -> { });
    }
}
