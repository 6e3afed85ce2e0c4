package steward.scene.json;

import java.util.List;
import java.util.Map;
import steward.text.TextFormat;
import tools.jackson.core.JsonGenerator;

/** Value of a scene file as it was written, with its position. Numbers keep their text. */
public sealed interface JsonValue {

    SourcePosition place();

    /** Returns how an error names it: {@code found ...}. */
    String shown();

    void write(JsonGenerator json);

    /** An object; fields in the order of the file. */
    record JsonObject(SourcePosition place, Map<String, Entry> entries) implements JsonValue {

        @Override
        public String shown() {
            return "an object";
        }

        @Override
        public void write(JsonGenerator json) {
            json.writeStartObject();
            entries.forEach((name, entry) -> {
                json.writeName(name);
                entry.value.write(json);
            });
            json.writeEndObject();
        }
    }

    /** A field of an object; the position is that of the name. */
    record Entry(SourcePosition place, JsonValue value) { }

    /** An array. */
    record JsonArray(SourcePosition place, List<JsonValue> values) implements JsonValue {

        @Override
        public String shown() {
            return values.isEmpty() ? "an empty array" : "an array";
        }

        @Override
        public void write(JsonGenerator json) {
            json.writeStartArray();
            values.forEach(value -> value.write(json));
            json.writeEndArray();
        }
    }

    /** A string, without its quotes and escapes. */
    record JsonText(SourcePosition place, String text) implements JsonValue {

        private static final int MOST_SHOWN = 60;

        @Override
        public String shown() {
            return '"' + TextFormat.beginning(text, MOST_SHOWN).replaceAll("\\p{Cntrl}", "?") + '"';
        }

        @Override
        public void write(JsonGenerator json) {
            json.writeString(text);
        }
    }

    /** A number; its text is kept, so that no digit is lost when the scene is written again. */
    record JsonNumber(SourcePosition place, String text) implements JsonValue {

        @Override
        public String shown() {
            return text;
        }

        @Override
        public void write(JsonGenerator json) {
            json.writeNumber(text);
        }
    }

    /** {@code true}, {@code false} or {@code null}. */
    record JsonLiteral(SourcePosition place, String text) implements JsonValue {

        @Override
        public String shown() {
            return text;
        }

        @Override
        public void write(JsonGenerator json) {
            json.writeRawValue(text);
        }
    }
}
