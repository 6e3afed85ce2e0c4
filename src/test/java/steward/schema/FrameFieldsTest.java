package steward.schema;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import steward.cli.shared.Games;
import steward.game.GameType;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * Fields of frames and answers: each that the schema of a game has is on the page of the game or on that of all games.
 * That frames are as the schema says is tested by {@link TrafficTest}, that answers are read so by the tests of each
 * game.
 */
class FrameFieldsTest {

    private static final List<String> FRAMES = List.of("setup", "turn", "end", "answer");

    static Stream<String> games() {
        return Games.types().types().stream().map(GameType::id);
    }

    @ParameterizedTest
    @MethodSource("games")
    void everyFieldIsExplained(String game) throws IOException {
        JsonNode parts = JsonMapper.shared().readTree(Schemas.text(game)).get("$defs");
        Set<String> fields = new TreeSet<>();
        FRAMES.forEach(frame -> collect(parts.get(frame), parts, new HashSet<>(), fields));
        assertTrue(fields.containsAll(List.of("type", "player", "turn", "message")), fields::toString);

        Path own = Path.of("docs", game + ".md");
        String pages = Files.readString(Path.of("docs/protocol.md")) + (Files.exists(own) ? Files.readString(own) : "");
        fields.removeIf(field -> pages.contains('"' + field + '"') || pages.contains('`' + field + '`'));
        assertEquals(Set.of(), fields);
    }

    private static void collect(JsonNode node, JsonNode parts, Set<String> seen, Set<String> fields) {
        if (node.path("properties").isObject()) {
            fields.addAll(node.get("properties").propertyNames());
        }
        String part = node.path("$ref").asString("");
        if (seen.add(part) && !part.isEmpty()) {
            collect(parts.get(part.substring(part.lastIndexOf('/') + 1)), parts, seen, fields);
        }
        node.forEach(each -> collect(each, parts, seen, fields));
    }
}
