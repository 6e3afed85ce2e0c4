package steward.cli.explain;

import java.util.Locale;
import steward.cli.streams.Json;
import steward.cli.streams.Streams;
import steward.game.GameSetup;
import steward.json.JsonObject;
import steward.scene.AccuracyChoice;
import steward.scene.Part;
import steward.scene.Scene;
import tools.jackson.core.JsonGenerator;

/** Explanation of a scene for programs: one JSON object on one line. */
final class ExplainJson {

    static void print(Streams streams, GameSetup setup) {
        Scene scene = setup.scene();
        Json.print(streams, out -> {
            out.writeStringProperty("scene", scene.name());
            out.writeStringProperty("game", scene.gameId());
            out.writeNumberProperty("players", scene.players());
            JsonObject.writeEach(out, "parts", setup.plan().parts(), part -> part(out, part));
            AccuracyChoice choice = setup.plan().accuracy();
            out.writeObjectPropertyStart("accuracy");
            out.writeStringProperty("rung", choice.rung().text());
            out.writeBooleanProperty("stated", choice.stated());
            out.writeStringProperty("why", choice.why());
            if (!choice.met().isEmpty()) {
                JsonObject.writeEach(out, "met", choice.met(), out::writeString);
            }
            out.writeEndObject();
            JsonObject.writeTexts(out, "warnings", setup.check());
        });
    }

    private static void part(JsonGenerator out, Part part) {
        out.writeStartObject();
        out.writeStringProperty("name", part.name());
        out.writeBooleanProperty("in", part.in());
        out.writeStringProperty("why", part.why());
        out.writeStringProperty("when", part.when().name().toLowerCase(Locale.ROOT));
        out.writeEndObject();
    }
}
