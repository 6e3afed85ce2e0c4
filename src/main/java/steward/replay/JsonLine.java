package steward.replay;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import steward.json.JsonNumbers;
import steward.scene.json.JsonProblem;
import steward.text.TextFormat;
import tools.jackson.core.JacksonException;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;
import tools.jackson.core.ObjectReadContext;

/**
 * One line of a replay, a JSON object of which only the top level is parsed. Objects and arrays are kept as bytes, so
 * that they can be compared with other bytes and parsed only when needed.
 */
public final class JsonLine {

    /** Characters of a value that an error quotes. */
    private static final int SHOWN = 40;

    /**
     * A field: where its name stands, and the text of a scalar (null for JSON null), or where an object or array
     * stands in the line.
     */
    private record Value(int nameFrom, JsonToken token, String text, int from, int to) { }

    private final String where;
    private final byte[] bytes;
    private final Map<String, Value> values = new LinkedHashMap<>();

    /**
     * @param where file and line, for errors
     * @throws ReplayException  if it is JSON but not one object, or a field is there twice
     * @throws JacksonException if it is not JSON
     */
    public JsonLine(String where, byte[] bytes) {
        this.where = where;
        this.bytes = bytes;
        try (JsonParser in = JsonNumbers.FACTORY.createParser(ObjectReadContext.empty(), bytes, 0, bytes.length)) {
            if (in.nextToken() != JsonToken.START_OBJECT) {
                throw new ReplayException(where + ": found " + (in.currentToken() == null ? "an empty line"
                    : JsonProblem.kind(in.currentToken())) + ", expected one object a line");
            }
            while (in.nextToken() == JsonToken.PROPERTY_NAME) {
                String name = in.currentName();
                int nameFrom = (int) in.currentTokenLocation().getByteOffset();
                if (values.put(name, value(in, nameFrom, in.nextToken())) != null) {
                    throw new ReplayException(where + ": " + name + ": found twice, expected once");
                }
            }
            if (in.nextToken() != null) {
                throw new ReplayException(where + ": found more behind the object, expected one object a line");
            }
        }
    }

    private static Value value(JsonParser in, int nameFrom, JsonToken token) {
        if (token != null && token.isStructStart()) {
            int from = (int) in.currentTokenLocation().getByteOffset();
            in.skipChildren();
            return new Value(nameFrom, token, null, from, (int) in.currentLocation().getByteOffset());
        }
        return new Value(nameFrom, token, token == JsonToken.VALUE_NULL ? null : in.getString(), -1, -1);
    }

    /** The hash of all that stands before a field, without the comma between. */
    public String hashBefore(String name) {
        return InputHash.of(bytes, 0, Math.max(0, values.get(name).nameFrom() - 1));
    }

    /** The names of its fields, in their order. */
    public Iterable<String> names() {
        return values.keySet();
    }

    public boolean has(String name) {
        return values.containsKey(name);
    }

    /** A string. */
    public String text(String name) {
        return require(name, JsonToken.VALUE_STRING, "a string").text();
    }

    /** True if the field is there and true. */
    boolean flag(String name) {
        return has(name) && values.get(name).token() == JsonToken.VALUE_TRUE;
    }

    /** A whole number. */
    public int integer(String name) {
        String text = require(name, JsonToken.VALUE_NUMBER_INT, "a whole number").text();
        try {
            return Integer.parseInt(text);
        } catch (NumberFormatException tooLarge) {
            throw new ReplayException(where + ": " + name + ": found " + text + ", expected a whole number below 2^31");
        }
    }

    /** A number, or {@code whenNull} for null. */
    public double number(String name, double whenNull) {
        Value value = values.get(name);
        if (value != null && value.token() == JsonToken.VALUE_NULL) {
            return whenNull;
        }
        if (value == null || !value.token().isNumeric()) {
            throw wrong(name, value, "a number or null");
        }
        return Double.parseDouble(value.text());
    }

    /** The bytes of an object, as written. */
    public byte[] object(String name) {
        return slice(require(name, JsonToken.START_OBJECT, "an object"));
    }

    /** The bytes of an array, as written. */
    public byte[] array(String name) {
        return slice(require(name, JsonToken.START_ARRAY, "an array"));
    }

    /** An array of strings and nulls; all null when the field is absent. */
    public String[] texts(String name, int count) {
        if (!has(name)) {
            return new String[count];
        }
        byte[] array = array(name);
        List<String> texts = new ArrayList<>();
        try (JsonParser in = JsonNumbers.FACTORY.createParser(ObjectReadContext.empty(), array, 0, array.length)) {
            in.nextToken();
            for (JsonToken token = in.nextToken(); token != JsonToken.END_ARRAY; token = in.nextToken()) {
                if (token != JsonToken.VALUE_STRING && token != JsonToken.VALUE_NULL) {
                    throw new ReplayException(where + ": " + name + "[" + texts.size() + "]: found "
                        + JsonProblem.kind(token)
                        + ", expected a string or null");
                }
                texts.add(token == JsonToken.VALUE_NULL ? null : in.getString());
            }
        }
        if (texts.size() != count) {
            throw new ReplayException(where + ": " + name + ": found " + texts.size() + " entries, expected " + count);
        }
        return texts.toArray(new String[0]);
    }

    /** One string field, or null, of each object in an array. */
    public String[] textsOf(String name, String field) {
        return objects(name).stream().map(object -> object.values.get(field)).map(value ->
            value != null && value.token() == JsonToken.VALUE_STRING ? value.text() : null).toArray(String[]::new);
    }

    /** The objects of an array, each taken apart. */
    public List<JsonLine> objects(String name) {
        byte[] array = array(name);
        List<JsonLine> objects = new ArrayList<>();
        try (JsonParser in = JsonNumbers.FACTORY.createParser(ObjectReadContext.empty(), array, 0, array.length)) {
            in.nextToken();
            for (JsonToken token = in.nextToken(); token != JsonToken.END_ARRAY; token = in.nextToken()) {
                String place = where + ": " + name + "[" + objects.size() + "]";
                if (token != JsonToken.START_OBJECT) {
                    throw new ReplayException(place + ": found " + JsonProblem.kind(token) + ", expected an object");
                }
                int from = (int) in.currentTokenLocation().getByteOffset();
                in.skipChildren();
                int to = (int) in.currentLocation().getByteOffset();
                objects.add(new JsonLine(place, Arrays.copyOfRange(array, from, to)));
            }
        }
        return objects;
    }

    /** File and line, for errors. */
    public String where() {
        return where;
    }

    public byte[] json() {
        return bytes;
    }

    private byte[] slice(Value value) {
        return Arrays.copyOfRange(bytes, value.from(), value.to());
    }

    private Value require(String name, JsonToken token, String expected) {
        Value value = values.get(name);
        if (value == null || value.token() != token) {
            throw wrong(name, value, expected);
        }
        return value;
    }

    /** A text as errors show it: its beginning, in double quotes. */
    static String quoted(String text) {
        return "\"" + TextFormat.beginning(text, SHOWN) + "\"";
    }

    private ReplayException wrong(String name, Value value, String expected) {
        String found = value == null ? "nothing" : value.token() == JsonToken.VALUE_STRING ? quoted(value.text())
            : value.text() != null ? TextFormat.beginning(value.text(), SHOWN)
            : value.token() == JsonToken.VALUE_NULL ? "null"
            : TextFormat.beginning(new String(slice(value), StandardCharsets.UTF_8), SHOWN);
        return new ReplayException(where + ": " + name + ": found " + found + ", expected " + expected);
    }
}
