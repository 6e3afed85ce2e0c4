package steward.minigame;

import steward.game.GameJson;
import steward.json.JsonNumbers;
import steward.physics.Bodies;
import tools.jackson.core.JacksonException;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;
import tools.jackson.core.ObjectReadContext;

/** The frames of the pond. An answer is {@code {"push":{"x":1,"y":2},"message":"optional"}}. */
final class PondJson implements GameJson {

    private static final String[] KINDS = {"hunter", "bubble", "cell", "fog"};

    private final Pond pond;
    private final String[] messages;

    PondJson(Pond pond) {
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
        out.writeArrayPropertyStart("zones");
        out.writeStartObject();
        JsonNumbers.write(out, "x", pond.settings().arena().x());
        JsonNumbers.write(out, "y", pond.settings().arena().y());
        JsonNumbers.write(out, "radius", pond.settings().arena().radius() / pond.turn());
        out.writeStringProperty("label", "calm");
        out.writeEndObject();
        out.writeEndArray();
        out.writeArrayPropertyStart("scores");
        for (double score : pond.scores()) {
            JsonNumbers.write(out, score);
        }
        out.writeEndArray();
        out.writeArrayPropertyStart("resources");
        for (double score : pond.scores()) {
            out.writeStartObject();
            JsonNumbers.write(out, "mass", score);
            JsonNumbers.write(out, "tenths", Math.rint(10 * score));
            out.writeEndObject();
        }
        out.writeEndArray();
    }

    @Override
    public void writeTurn(JsonGenerator out, int player) {
        writeBodies(out);
    }

    private void writeBodies(JsonGenerator out) {
        Bodies bodies = pond.bodies();
        out.writeArrayPropertyStart("bodies");
        for (int k = 0; k < bodies.size(); k++) {
            out.writeStartObject();
            out.writeNumberProperty("id", bodies.id(k));
            out.writeStringProperty("kind", KINDS[bodies.kind[k]]);
            int owner = pond.ownerOf(bodies.id(k));
            if (owner >= 0) {
                out.writeNumberProperty("owner", owner);
            }
            JsonNumbers.write(out, "x", bodies.x[k]);
            JsonNumbers.write(out, "y", bodies.y[k]);
            JsonNumbers.write(out, "vx", bodies.vx[k]);
            JsonNumbers.write(out, "vy", bodies.vy[k]);
            JsonNumbers.write(out, "radius", bodies.radius[k]);
            JsonNumbers.write(out, "mass", bodies.mass[k]);
            out.writeEndObject();
        }
        out.writeEndArray();
    }

    @Override
    public String readAnswer(int player, byte[] line, int length) {
        messages[player] = null;
        try (JsonParser in = JsonNumbers.FACTORY.createParser(ObjectReadContext.empty(), line, 0, length)) {
            if (in.nextToken() != JsonToken.START_OBJECT) {
                return "found no object, expected {\"push\":...}";
            }
            String wrong = "push: found nothing, expected an object";
            while (in.nextToken() == JsonToken.PROPERTY_NAME) {
                String name = in.currentName();
                JsonToken value = in.nextToken();
                if (name.equals("push")) {
                    wrong = readCommand(in, player);
                    if (wrong != null) {
                        return wrong;
                    }
                } else if (name.equals("message") && value == JsonToken.VALUE_STRING) {
                    messages[player] = in.getString();
                } else {
                    return name + ": found an unknown field, expected push and message";
                }
            }
            return wrong;
        } catch (JacksonException problem) {
            return "not JSON: " + problem.getOriginalMessage();
        }
    }

    @Override
    public String message(int player) {
        return messages[player];
    }

    @Override
    public void writeCommand(JsonGenerator out, int player) {
        out.writeStartObject();
        JsonNumbers.write(out, "x", pond.pushX(player));
        JsonNumbers.write(out, "y", pond.pushY(player));
        out.writeEndObject();
    }

    @Override
    public String readCommand(JsonParser in, int player) {
        double x = Double.NaN;
        double y = Double.NaN;
        if (in.currentToken() != JsonToken.START_OBJECT) {
            return "push: found no object, expected {\"x\":..,\"y\":..}";
        }
        while (in.nextToken() == JsonToken.PROPERTY_NAME) {
            String name = in.currentName();
            if (!in.nextToken().isNumeric()) {
                return "push." + name + ": found no number, expected one";
            }
            x = name.equals("x") ? in.getDoubleValue() : x;
            y = name.equals("y") ? in.getDoubleValue() : y;
        }
        double length = Math.sqrt(x * x + y * y);
        if (!(length <= pond.settings().push())) {
            return "push: found a length of " + length + ", expected at most " + pond.settings().push();
        }
        pond.command(player, x, y);
        return null;
    }

    @Override
    public void writeState(JsonGenerator out) {
        writeBodies(out);
        out.writeArrayPropertyStart("passing");
        for (int k = 0; k < pond.bodies().passing().size(); k++) {
            out.writeStartArray();
            out.writeNumber(pond.bodies().passing().first(k));
            out.writeNumber(pond.bodies().passing().second(k));
            out.writeEndArray();
        }
        out.writeEndArray();
    }

    @Override
    public void writeDrawing(JsonGenerator out) {
        double radius = pond.settings().arena().radius();
        out.writeObjectPropertyStart("field");
        JsonNumbers.write(out, "x", pond.settings().arena().x() - radius);
        JsonNumbers.write(out, "y", pond.settings().arena().y() - radius);
        JsonNumbers.write(out, "width", 2 * radius);
        JsonNumbers.write(out, "height", 2 * radius);
        out.writeEndObject();
        out.writeArrayPropertyStart("bodies");
        Bodies bodies = pond.bodies();
        for (int k = 0; k < bodies.size(); k++) {
            out.writeStartObject();
            out.writeNumberProperty("id", bodies.id(k));
            out.writeStringProperty("kind", KINDS[bodies.kind[k]]);
            JsonNumbers.write(out, "radius", bodies.radius[k]);
            int owner = pond.ownerOf(bodies.id(k));
            if (owner >= 0) {
                out.writeNumberProperty("owner", owner);
                out.writeStringProperty("label", Integer.toString(owner));
            }
            out.writeEndObject();
        }
        out.writeEndArray();
    }
}
