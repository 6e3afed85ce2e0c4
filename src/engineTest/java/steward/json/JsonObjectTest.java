package steward.json;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import tools.jackson.core.JsonGenerator;

/** Objects are whole, with nothing before or behind them. */
class JsonObjectTest {

    private static String written(Consumer<JsonGenerator> fields) {
        return new String(JsonObject.of(fields), StandardCharsets.UTF_8);
    }

    @Test
    void fieldsStandBetweenBraces() {
        assertEquals("{}", written(out -> { }));
        assertEquals("{\"a\":1,\"b\":\"\u00e4\"}", written(out -> {
            JsonNumbers.write(out, "a", 1);
            out.writeStringProperty("b", "\u00e4");
        }));
    }

    @Test
    void itemsAreObjectsOfAnArray() {
        assertEquals("{\"rows\":[{\"n\":1},{\"n\":2.5}],\"none\":[]}", written(out -> {
            JsonObject.writeAll(out, "rows", List.of(1.0, 2.5), n -> JsonNumbers.write(out, "n", n));
            JsonObject.writeAll(out, "none", List.<Double>of(), n -> JsonNumbers.write(out, "n", n));
        }));
    }
}
