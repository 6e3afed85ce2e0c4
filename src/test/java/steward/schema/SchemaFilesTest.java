package steward.schema;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.networknt.schema.Schema;
import com.networknt.schema.SchemaLocation;
import com.networknt.schema.SchemaRegistry;
import com.networknt.schema.SpecificationVersion;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BiConsumer;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.FieldSource;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** The schemas themselves: valid, strict where we write, and every field explained. */
class SchemaFilesTest {

    /** One for each game, and the messages between a league and its workers. */
    static final List<String> NAMES = List.of("machines", Schemas.POD_RACE, Schemas.SEARCH_RACE, Schemas.MEAN_MAX,
        Schemas.FANTASTIC_BITS, Schemas.POKER_CHIP_RACE, "guest");

    private static JsonNode schema(String name) {
        return JsonMapper.shared().readTree(Schemas.text(name));
    }

    @ParameterizedTest
    @FieldSource("NAMES")
    void validBy202012(String name) {
        Schema meta = SchemaRegistry.withDefaultDialect(SpecificationVersion.DRAFT_2020_12)
            .getSchema(SchemaLocation.of("https://json-schema.org/draft/2020-12/schema"));

        assertEquals(List.of(), Schemas.problems(meta, Schemas.text(name)));
        assertTrue(Schemas.problems(meta, "{\"type\":\"objekt\"}").size() > 0, "the meta-schema refuses something");
    }

    @ParameterizedTest
    @FieldSource("NAMES")
    void everyFieldHasTitleAndDescription(String name) {
        List<String> bare = new ArrayList<>();
        List<String> seen = new ArrayList<>();
        walk("", schema(name), (path, part) -> part.path("properties").forEachEntry((field, definition) -> {
            boolean told = definition.has("title") && definition.has("description") || definition.has("$ref")
                || part.has("$ref");                       // refines a field of that
            (told ? seen : bare).add(path + "/" + field);
        }));

        assertEquals(List.of(), bare);
        assertTrue(seen.size() >= 5, seen::toString);
    }

    @ParameterizedTest
    @FieldSource("NAMES")
    void everyObjectIsClosedButTheSceneAndWhatBotsReport(String name) {
        List<String> open = new ArrayList<>();
        walk("", schema(name), (path, part) -> {
            if (part.path("type").asString("").equals("object") && !part.path("additionalProperties").isBoolean()
                    && !part.path("unevaluatedProperties").isBoolean()) {
                open.add(path);
            }
        });

        open.removeIf(path -> path.endsWith("/data") || path.endsWith("/replayHeader/properties/scene"));
        assertEquals(List.of(), open);
    }

    /** Looks at all parts; at a map of fields only by its fields, of which one may be called "properties" too. */
    private static void walk(String path, JsonNode part, BiConsumer<String, JsonNode> look) {
        look.accept(path, part);
        for (JsonNode element : part.isArray() ? part : List.<JsonNode>of()) {
            walk(path + "/[]", element, look);
        }
        part.forEachEntry((key, inner) -> {
            if (key.equals("properties")) {
                inner.forEachEntry((field, definition) -> walk(path + "/properties/" + field, definition, look));
            } else {
                walk(path + "/" + key, inner, look);
            }
        });
    }
}
