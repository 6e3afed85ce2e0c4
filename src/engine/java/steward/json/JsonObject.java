package steward.json;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.function.Consumer;
import java.util.function.IntConsumer;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.ObjectWriteContext;

/** Writer of a JSON object from its first brace to its last. */
public final class JsonObject {

    private JsonObject() { }

    /** @param fields writes everything between the braces */
    public static byte[] of(Consumer<JsonGenerator> fields) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (JsonGenerator out = JsonNumbers.FACTORY.createGenerator(ObjectWriteContext.empty(), bytes)) {
            out.writeStartObject();
            fields.accept(out);
            out.writeEndObject();
        }
        return bytes.toByteArray();
    }

    /** As {@link #of}, as text. */
    public static String text(Consumer<JsonGenerator> fields) {
        return new String(of(fields), StandardCharsets.UTF_8);
    }

    /** Writes one field, an array of objects, each with the fields of an item. */
    public static <T> void writeAll(JsonGenerator out, String name, Iterable<T> items, Consumer<T> fields) {
        out.writeArrayPropertyStart(name);
        for (T item : items) {
            out.writeStartObject();
            fields.accept(item);
            out.writeEndObject();
        }
        out.writeEndArray();
    }

    /** Writes one field, an array of objects, each with the fields of an index from 0. */
    public static void writeAll(JsonGenerator out, String name, int count, IntConsumer fields) {
        out.writeArrayPropertyStart(name);
        for (int k = 0; k < count; k++) {
            out.writeStartObject();
            fields.accept(k);
            out.writeEndObject();
        }
        out.writeEndArray();
    }

    /** Writes one field, an array; each element is written for an item. */
    public static <T> void writeEach(JsonGenerator out, String name, Iterable<T> items, Consumer<T> element) {
        out.writeArrayPropertyStart(name);
        items.forEach(element);
        out.writeEndArray();
    }

    /** Writes one field, an array; each element is written for an index from 0. */
    public static void writeEach(JsonGenerator out, String name, int count, IntConsumer element) {
        out.writeArrayPropertyStart(name);
        for (int k = 0; k < count; k++) {
            element.accept(k);
        }
        out.writeEndArray();
    }

    /** Writes one field, an array of texts; {@code null} is written as such. */
    public static void writeTexts(JsonGenerator out, String name, Iterable<String> texts) {
        out.writeArrayPropertyStart(name);
        texts.forEach(out::writeString);
        out.writeEndArray();
    }
}
