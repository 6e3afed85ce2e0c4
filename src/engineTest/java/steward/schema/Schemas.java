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
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ObjectNode;

/** The JSON Schemas that come with the program. */
public final class Schemas {

    static final String POD_RACE = "pod-race";
    static final String SEARCH_RACE = "search-race";
    static final String MEAN_MAX = "mean-max";
    static final String FANTASTIC_BITS = "fantastic-bits";
    static final String POKER_CHIP_RACE = "poker-chip-race";
    static final List<String> NAMES = List.of("setup", "turn", "end", "answer", "replay", "scene");

    private static final Map<String, Schema> OPEN = new ConcurrentHashMap<>();

    private Schemas() {
    }

    /** The whole schema of a game. */
    static String text(String game) {
        try (InputStream in = Schemas.class.getResourceAsStream("/steward/schemas/" + game + ".json")) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException problem) {
            throw new UncheckedIOException(problem);
        }
    }

    /** A part of a game's schema as a schema of its own. */
    static String text(String game, String name) {
        return JsonMapper.shared().readValue(text(game), ObjectNode.class).put("$ref", "#/$defs/" + name).toString();
    }

    static Schema open(String name) {
        return open(POD_RACE, name);
    }

    /** Opens a part of a game's schema, once for all tests: reading it takes longer than asking it. */
    public static Schema open(String game, String name) {
        return OPEN.computeIfAbsent(game + " " + name, part -> SchemaRegistry
            .withDefaultDialect(SpecificationVersion.DRAFT_2020_12).getSchema(text(game, name), InputFormat.JSON));
    }

    /** Returns the problems of a text by a schema; none if it is valid. */
    static List<String> problems(Schema schema, String json) {
        return schema.validate(json, InputFormat.JSON).stream().map(Error::toString).toList();
    }
}
