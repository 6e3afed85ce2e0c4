package steward.schema;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.networknt.schema.Schema;
import com.networknt.schema.SchemaLocation;
import com.networknt.schema.SchemaRegistry;
import com.networknt.schema.SpecificationVersion;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.FieldSource;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** The schemas themselves: valid, strict where we write, and every field explained. */
class SchemaFilesTest {

    /** One for each game, and the messages between a league and its workers. */
    static final List<String> NAMES = List.of("machines", Schemas.POD_RACE, Schemas.SEARCH_RACE, Schemas.MEAN_MAX,
        Schemas.FANTASTIC_BITS, Schemas.POKER_CHIP_RACE, "guest");

    private static String text(String name) {
        return Schemas.text(name);
    }

    @ParameterizedTest
    @FieldSource("NAMES")
    void validBy202012(String name) {
        Schema meta = SchemaRegistry.withDefaultDialect(SpecificationVersion.DRAFT_2020_12)
            .getSchema(SchemaLocation.of("https://json-schema.org/draft/2020-12/schema"));

        assertEquals(List.of(), Schemas.problems(meta, text(name)));
        assertTrue(Schemas.problems(meta, "{\"type\":\"objekt\"}").size() > 0, "the meta-schema refuses something");
    }

    @ParameterizedTest
    @FieldSource("NAMES")
    void everyFieldHasTitleAndDescription(String name) {
        List<String> bare = new ArrayList<>();
        int fields = inspect("", JsonMapper.shared().readTree(text(name)), bare);

        assertEquals(List.of(), bare);
        assertTrue(fields >= 5, "fields seen: " + fields);
    }

    @ParameterizedTest
    @FieldSource("NAMES")
    void everyObjectIsClosedButTheSceneAndWhatBotsReport(String name) {
        List<String> open = new ArrayList<>();
        closed("", JsonMapper.shared().readTree(text(name)), open);

        open.removeIf(path -> path.endsWith("/data") || path.endsWith("/replayHeader/properties/scene"));
        assertEquals(List.of(), open);
    }

    private static int inspect(String path, JsonNode schema, List<String> bare) {
        int fields = 0;
        JsonNode properties = schema.get("properties");
        if (properties != null) {
            for (String field : properties.propertyNames()) {
                JsonNode definition = properties.get(field);
                boolean told = definition.has("title") && definition.has("description") || definition.has("$ref")
                    || schema.has("$ref");                 // refines a field of that
                if (!told) {
                    bare.add(path + "/" + field);
                }
                fields++;
            }
        }
        for (String key : schema.propertyNames()) {
            // A field may be called "properties" too.
            for (JsonNode part : key.equals("properties") ? schema.get(key) : List.of(schema.get(key))) {
                fields += inspect(path + "/" + key, part, bare);
            }
        }
        for (JsonNode element : schema.isArray() ? schema : JsonMapper.shared().createArrayNode()) {
            fields += inspect(path + "/[]", element, bare);
        }
        return fields;
    }

    private static void closed(String path, JsonNode schema, List<String> open) {
        boolean isObject = schema.has("type") && schema.get("type").isString()
            && schema.get("type").stringValue().equals("object");
        if (isObject && !schema.path("additionalProperties").isBoolean()
            && !schema.path("unevaluatedProperties").isBoolean()) {
            open.add(path);
        }
        for (String key : schema.propertyNames()) {
            closed(path + "/" + key, schema.get(key), open);
        }
        for (JsonNode element : schema.isArray() ? schema : JsonMapper.shared().createArrayNode()) {
            closed(path + "/[]", element, open);
        }
    }
}
