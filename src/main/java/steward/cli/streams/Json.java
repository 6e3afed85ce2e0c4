package steward.cli.streams;

import java.io.PrintStream;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import steward.json.JsonNumbers;
import steward.replay.page.UnclosedOutputStream;
import steward.report.Fields;
import steward.text.TextFormat;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;
import tools.jackson.core.ObjectReadContext;
import tools.jackson.core.ObjectWriteContext;
import tools.jackson.core.SerializableString;
import tools.jackson.core.io.CharacterEscapes;
import tools.jackson.core.io.SerializedString;
import tools.jackson.core.json.JsonFactory;

/**
 * Reader of small JSON values without the start-up cost of a data-binding library, and builder of the objects that
 * commands print. Read objects are maps in their written order, arrays are lists, numbers are doubles, null is null; a
 * number such as 1e999, of which a double is not finite, is {@link Fields.Raw}.
 */
public final class Json {

    private static final int DELETE = 0x7f;

    /** Escapes what cannot be seen. */
    private static final JsonFactory PRINTED = JsonNumbers.FACTORY.rebuild().characterEscapes(new Unseen()).build();

    private Json() { }

    private static final class Unseen extends CharacterEscapes {

        private static final long serialVersionUID = 1;

        @Override
        public int[] getEscapeCodesForAscii() {
            int[] codes = standardAsciiEscapesForJSON();
            codes[DELETE] = ESCAPE_STANDARD;
            return codes;
        }

        @Override
        public SerializableString getEscapeSequence(int character) {
            char c = (char) character;
            return TextFormat.isUnseen(c) ? new SerializedString(TextFormat.escape(c)) : null;
        }
    }

    public static Map<String, Object> object(byte[] json) {
        try (JsonParser in = JsonNumbers.FACTORY.createParser(ObjectReadContext.empty(), json, 0, json.length)) {
            in.nextToken();
            return object(in);
        }
    }

    public static Map<String, Object> object(String json) {
        try (JsonParser in = JsonNumbers.FACTORY.createParser(ObjectReadContext.empty(), json)) {
            in.nextToken();
            return object(in);
        }
    }

    public static List<Object> array(byte[] json) {
        try (JsonParser in = JsonNumbers.FACTORY.createParser(ObjectReadContext.empty(), json, 0, json.length)) {
            in.nextToken();
            return array(in);
        }
    }

    /** Prints one object on a line of its own. */
    public static void print(Streams streams, Fields fields) {
        print(streams.out(), fields::write);
    }

    /** As above, of fields that write themselves, to one of the streams. */
    public static void print(PrintStream to, Consumer<JsonGenerator> fields) {
        try (JsonGenerator out = PRINTED.createGenerator(ObjectWriteContext.empty(), new UnclosedOutputStream(to))) {
            out.writeStartObject();
            fields.accept(out);
            out.writeEndObject();
        }
        to.print('\n');
    }

    private static Map<String, Object> object(JsonParser in) {
        Map<String, Object> fields = new LinkedHashMap<>();
        while (in.nextToken() == JsonToken.PROPERTY_NAME) {
            String name = in.currentName();
            in.nextToken();
            fields.put(name, value(in));
        }
        return fields;
    }

    private static List<Object> array(JsonParser in) {
        List<Object> values = new ArrayList<>();
        while (in.nextToken() != JsonToken.END_ARRAY) {
            values.add(value(in));
        }
        return values;
    }

    private static Object value(JsonParser in) {
        return switch (in.currentToken()) {
            case START_OBJECT -> object(in);
            case START_ARRAY -> array(in);
            case VALUE_NUMBER_INT, VALUE_NUMBER_FLOAT -> number(in);
            case VALUE_TRUE -> Boolean.TRUE;
            case VALUE_FALSE -> Boolean.FALSE;
            case VALUE_NULL -> null;
            default -> in.getString();
        };
    }

    private static Object number(JsonParser in) {
        double number = in.getDoubleValue();
        return Double.isFinite(number) ? (Object) number : new Fields.Raw(in.getString());
    }

    /** The objects of an array; empty if it is missing. */
    public static List<Map<?, ?>> objects(Object array) {
        return !(array instanceof List<?> list) ? List.of() : list.stream().filter(each -> each instanceof Map)
            .<Map<?, ?>>map(each -> (Map<?, ?>) each).toList();
    }

    /** A number, or NaN if there is none. */
    public static double number(Object value) {
        return value instanceof Double number ? number
            : value instanceof Fields.Raw beyond ? Double.parseDouble(beyond.json()) : Double.NaN;
    }

    /** A scalar as readable text; {@code -} for nothing. */
    public static String word(Object value, int decimals) {
        if (value instanceof Double number) {
            return TextFormat.number(number, decimals);
        }
        if (value instanceof Boolean flag) {
            return flag ? "yes" : "no";
        }
        return value == null ? "-" : TextFormat.plain(value.toString());
    }
}
