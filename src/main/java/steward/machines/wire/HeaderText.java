package steward.machines.wire;

import java.io.StringWriter;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.ObjectWriteContext;
import tools.jackson.core.json.JsonFactory;

/** Builder of a message's header, a JSON object, field by field. */
public final class HeaderText {

    private static final JsonFactory JSON = new JsonFactory();

    private final Map<String, Object> fields = new LinkedHashMap<>();

    /** A text; what is not there is left out. */
    public HeaderText put(String name, String text) {
        if (text != null) {
            fields.put(name, text);
        }
        return this;
    }

    /** A whole number. */
    public HeaderText put(String name, long number) {
        fields.put(name, number);
        return this;
    }

    public HeaderText put(String name, boolean flag) {
        fields.put(name, flag);
        return this;
    }

    public HeaderText put(String name, List<HeaderText> objects) {
        fields.put(name, List.copyOf(objects));
        return this;
    }

    public HeaderText putTexts(String name, List<String> texts) {
        fields.put(name, List.copyOf(texts));
        return this;
    }

    /** The object on one line. */
    public String text() {
        StringWriter out = new StringWriter();
        try (JsonGenerator json = JSON.createGenerator(ObjectWriteContext.empty(), out)) {
            write(json);
        }
        return out.toString();
    }

    private void write(JsonGenerator json) {
        json.writeStartObject();
        fields.forEach((name, value) -> {
            json.writeName(name);
            write(json, value);
        });
        json.writeEndObject();
    }

    private static void write(JsonGenerator json, Object value) {
        if (value instanceof HeaderText object) {
            object.write(json);
        } else if (value instanceof List<?> list) {
            json.writeStartArray();
            list.forEach(each -> write(json, each));
            json.writeEndArray();
        } else if (value instanceof Boolean flag) {
            json.writeBoolean(flag);
        } else if (value instanceof Long number) {
            json.writeNumber(number);
        } else {
            json.writeString((String) value);
        }
    }
}
