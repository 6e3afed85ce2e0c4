package steward.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import steward.json.JsonObject;

/** Named values as JSON: every kind of value, in order. The expected texts are those of RFC 8259, written by hand. */
class FieldsTest {

    private static String json(Object... namesAndValues) {
        return JsonObject.text(Fields.of(namesAndValues)::write);
    }

    @Test
    void valuesAreWrittenByTheirKind() {
        assertEquals("{\"text\":\"a\\\"b\",\"none\":null,\"count\":3,\"long\":5000000000,\"whole\":2,\"part\":0.5,"
            + "\"flag\":true,\"word\":\"seconds\",\"file\":\"a/b\"}", json("text", "a\"b", "none", null, "count", 3,
            "long", 5_000_000_000L, "whole", 2.0, "part", 0.5, "flag", true, "word", TimeUnit.SECONDS, "file",
            Path.of("a", "b")));
    }

    @Test
    void aNumberThatIsNotFiniteIsNull() {
        assertEquals("{\"a\":null,\"b\":null,\"c\":null}", json("a", Double.NaN, "b", Double.POSITIVE_INFINITY, "c",
            Fields.decimal(Double.NaN)));
        assertNull(Fields.decimal(null));
    }

    @Test
    void aDecimalKeepsItsPoint() {
        assertEquals("{\"a\":2.0,\"b\":[0.5,1.0E10]}", json("a", Fields.decimal(2.0), "b",
            List.of(Fields.decimal(0.5), Fields.decimal(1e10))));
    }

    @Test
    void objectsAndArraysNest() {
        assertEquals("{\"object\":{\"a\":1,\"b\":{}},\"map\":{\"7\":[\"x\",null]},\"list\":[{\"k\":0},{\"k\":1}]}",
            json("object", Fields.of("a", 1).and(Fields.of("b", Fields.of())), "map",
                Map.of(7, Arrays.asList("x", null)), "list", Fields.each(2, k -> Fields.of("k", k))));
    }

    @Test
    void anArrayIsComputedWhileItIsWritten() {
        List<Integer> items = Arrays.asList(1, 2);
        Fields fields = Fields.of("squares", Fields.each(items, item -> item * item));
        items.set(1, 3);
        assertEquals("{\"squares\":[1,9]}", JsonObject.text(fields::write));
    }
}
