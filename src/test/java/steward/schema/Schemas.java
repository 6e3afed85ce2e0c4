package steward.schema;

import com.networknt.schema.Error;
import com.networknt.schema.InputFormat;
import com.networknt.schema.Schema;
import com.networknt.schema.SchemaRegistry;
import com.networknt.schema.SpecificationVersion;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;

/** The JSON Schemas that come with the program. */
final class Schemas {

    static final String POD_RACE = "pod-race";
    static final String SEARCH_RACE = "search-race";
    static final String MEAN_MAX = "mean-max";
    static final String FANTASTIC_BITS = "fantastic-bits";
    static final String POKER_CHIP_RACE = "poker-chip-race";
    static final List<String> NAMES = List.of("setup", "turn", "end", "answer", "replay", "scene");

    private Schemas() {
    }

    static String text(String name) {
        return text(POD_RACE, name);
    }

    static String text(String game, String name) {
        try (InputStream in = Schemas.class.getResourceAsStream("/steward/schemas/" + game + "/" + name + ".json")) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException problem) {
            throw new UncheckedIOException(problem);
        }
    }

    static Schema open(String name) {
        return open(POD_RACE, name);
    }

    static Schema open(String game, String name) {
        return SchemaRegistry.withDefaultDialect(SpecificationVersion.DRAFT_2020_12)
            .getSchema(text(game, name), InputFormat.JSON);
    }

    /** What a schema has against a text; nothing if it is valid. */
    static List<String> problems(Schema schema, String json) {
        return schema.validate(json, InputFormat.JSON).stream().map(Error::toString).toList();
    }
}
