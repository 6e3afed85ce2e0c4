package steward.scene.json;

import java.io.StringWriter;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import steward.scene.json.JsonValue.Entry;
import steward.scene.json.JsonValue.JsonArray;
import steward.scene.json.JsonValue.JsonLiteral;
import steward.scene.json.JsonValue.JsonNumber;
import steward.scene.json.JsonValue.JsonObject;
import tools.jackson.core.JacksonException;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;
import tools.jackson.core.ObjectReadContext;
import tools.jackson.core.ObjectWriteContext;
import tools.jackson.core.json.JsonFactory;
import tools.jackson.core.json.JsonWriteFeature;

/** Parser and writer of JSON text as values with their positions, within {@link JsonLimits}. */
public final class JsonTree {

    /** Names and texts are written in ASCII: a scene then survives any encoding. */
    private static final JsonFactory JSON = JsonFactory.builder().enable(JsonWriteFeature.ESCAPE_NON_ASCII).build();

    private final String source;
    private final String what;
    private final JsonParser json;
    private final JsonLimits limits;
    private int depth;

    private JsonTree(String source, String what, JsonParser json) {
        this.source = source;
        this.what = what;
        this.json = json;
        limits = new JsonLimits(source);
    }

    /**
     * @param text   one JSON object
     * @param source names the text in errors
     * @param what   says in errors what the text should be, as in {@code a scene}
     * @throws SceneException if it is not JSON, not one object, beyond a limit, or an object has a field twice
     */
    public static JsonObject read(String text, String source, String what) {
        try (JsonParser json = JSON.createParser(ObjectReadContext.empty(), text)) {
            return new JsonTree(source, what, json).readFile();
        }
    }

    /** Writes a value on one line, in the order and with the number texts it was read with. */
    static String write(JsonValue value) {
        StringWriter out = new StringWriter();
        try (JsonGenerator json = JSON.createGenerator(ObjectWriteContext.empty(), out)) {
            value.write(json);
        }
        return out.toString();
    }

    private JsonObject readFile() {
        try {
            return readOnlyObject();
        } catch (JacksonException e) {
            SourcePosition place = SourcePosition.of(e.getLocation() == null ? json.currentLocation()
                : e.getLocation());
            String why = JsonProblem.message(e);
            throw SceneException.at(source, place, "", "not JSON: " + why);
        }
    }

    private JsonObject readOnlyObject() {
        if (json.nextToken() == null) {
            throw SceneException.at(source, new SourcePosition(1, 1), "", "found an empty file, expected " + what
                + " in JSON");
        }
        JsonValue value = value("");
        if (!(value instanceof JsonObject)) {
            throw SceneException.at(source, value.place(), "", "found " + value.shown() + ", expected an object");
        }
        if (json.nextToken() != null) {
            throw SceneException.at(source, place(), "",
                "found more after the end of " + what + ", expected the end of the file");
        }
        return (JsonObject) value;
    }

    /** The value that begins at the current token. */
    private JsonValue value(String path) {
        SourcePosition place = place();
        limits.value(place, path);
        return switch (json.currentToken()) {
            case START_OBJECT -> object(place, path);
            case START_ARRAY -> array(place, path);
            case VALUE_STRING -> text(place, path);
            case VALUE_NUMBER_INT, VALUE_NUMBER_FLOAT -> new JsonNumber(place, json.getString());
            default -> new JsonLiteral(place, json.getString());
        };
    }

    private JsonValue.JsonText text(SourcePosition place, String path) {
        String text = json.getString();
        limits.text(text, place, path);
        return new JsonValue.JsonText(place, text);
    }

    private JsonObject object(SourcePosition place, String path) {
        limits.depth(++depth, place, path);
        Map<String, Entry> entries = new LinkedHashMap<>();
        while (json.nextToken() != JsonToken.END_OBJECT) {
            String name = json.currentName();
            SourcePosition namePlace = place();
            limits.name(name, namePlace, path);
            String fieldPath = path.isEmpty() ? name : path + "." + name;
            limits.fields(entries.size() + 1, namePlace, fieldPath);
            if (entries.containsKey(name)) {
                throw SceneException.at(source, namePlace, fieldPath, "found the field a second time, expected it once "
                    + "(the first is in line " + entries.get(name).place().line() + ")");
            }
            json.nextToken();
            entries.put(name, new Entry(namePlace, value(fieldPath)));
        }
        depth--;
        return new JsonObject(place, entries);
    }

    private JsonArray array(SourcePosition place, String path) {
        limits.depth(++depth, place, path);
        List<JsonValue> values = new ArrayList<>();
        while (json.nextToken() != JsonToken.END_ARRAY) {
            limits.elements(values.size() + 1, place(), path);
            values.add(value(path + "[" + values.size() + "]"));
        }
        depth--;
        return new JsonArray(place, values);
    }

    private SourcePosition place() {
        return SourcePosition.of(json.currentTokenLocation());
    }
}
