package steward.report;

import java.nio.file.Path;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.function.Function;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import steward.json.JsonNumbers;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.io.NumberOutput;

/**
 * Named values of a result in their order, an object of JSON. A value is {@code null}, a number, a boolean, other
 * fields, a map or an {@link Iterable} of such; a constant of an enumeration becomes a word in lower case, and anything
 * else a text. A number that is not finite is null.
 */
public final class Fields {

    private final Map<String, Object> values = new LinkedHashMap<>();

    private Fields() { }

    /** JSON that stands as it is. */
    public record Raw(String json) {

        @Override
        public String toString() {
            return json;
        }
    }

    /** As {@link Map#of()}, in this order, of any length, and with {@code null} for a value. */
    public static Fields of(Object... namesAndValues) {
        return new Fields().with(namesAndValues);
    }

    /** Adds more behind these. @return this */
    public Fields with(Object... namesAndValues) {
        for (int k = 0; k < namesAndValues.length; k += 2) {
            values.put((String) namesAndValues[k], namesAndValues[k + 1]);
        }
        return this;
    }

    /** Adds those of others behind these. @return this */
    public Fields and(Fields others) {
        values.putAll(others.values);
        return this;
    }

    /** A number with a point also where it is whole; {@code null} where there is none. */
    public static Raw decimal(Double value) {
        return value == null || !Double.isFinite(value) ? null : new Raw(NumberOutput.toString(value, true));
    }

    /** An array with a value for each item; it is computed while it is written. */
    public static <T> Iterable<Object> each(Collection<T> items, Function<? super T, ?> value) {
        return () -> items.stream().<Object>map(value).iterator();
    }

    /** An array with a value for each index from 0; it is computed while it is written. */
    public static Iterable<Object> each(int count, IntFunction<?> value) {
        return () -> IntStream.range(0, count).<Object>mapToObj(value).iterator();
    }

    /** Writes them, without the braces around them. */
    public void write(JsonGenerator out) {
        writeAll(out, values);
    }

    private static void writeAll(JsonGenerator out, Map<?, ?> fields) {
        fields.forEach((name, value) -> {
            out.writeName(name.toString());
            write(out, value);
        });
    }

    /** Writes a value of the kinds above. */
    public static void write(JsonGenerator out, Object value) {
        if (value == null || value instanceof Double number && !Double.isFinite(number)) {
            out.writeNull();
        } else if (value instanceof Double number) {
            JsonNumbers.write(out, number);
        } else if (value instanceof Number number) {
            out.writeNumber(number.longValue());
        } else if (value instanceof Boolean flag) {
            out.writeBoolean(flag);
        } else if (value instanceof Raw raw) {
            out.writeRawValue(raw.json());
        } else if (value instanceof Fields || value instanceof Map) {
            out.writeStartObject();
            writeAll(out, value instanceof Fields fields ? fields.values : (Map<?, ?>) value);
            out.writeEndObject();
        } else if (value instanceof Iterable<?> elements && !(value instanceof Path)) {
            out.writeStartArray();
            elements.forEach(each -> write(out, each));
            out.writeEndArray();
        } else {
            out.writeString(value instanceof Enum ? value.toString().toLowerCase(Locale.ROOT) : value.toString());
        }
    }
}
