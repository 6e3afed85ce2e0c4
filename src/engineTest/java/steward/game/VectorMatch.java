package steward.game;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.zip.GZIPInputStream;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * One match of a published referee, recorded turn by turn at full precision.
 *
 * @param name   of its file
 * @param header what was played
 * @param start  the state before the first turn
 * @param turns  one by one
 * @param end    how it ended
 */
public record VectorMatch(String name, JsonNode header, JsonNode start, List<JsonNode> turns, JsonNode end) {

    /** Reads a match from its file: JSON Lines by gzip. */
    public static VectorMatch read(Path file) {
        List<JsonNode> lines = new ArrayList<>();
        try (BufferedReader in = new BufferedReader(new InputStreamReader(
                new GZIPInputStream(Files.newInputStream(file)), StandardCharsets.UTF_8))) {
            in.lines().forEach(line -> lines.add(JsonMapper.shared().readTree(line)));
        } catch (IOException problem) {
            throw new UncheckedIOException(file.toString(), problem);
        }
        return new VectorMatch(file.getFileName().toString(), lines.get(0), lines.get(1).get("state"),
            lines.subList(2, lines.size() - 1), lines.get(lines.size() - 1));
    }

    /** Returns the seed, 0 in games whose start no seed decides. */
    public long seed() {
        return Long.parseLong(header.path("seed").asString("0"));
    }

    /** True if the state before the first turn was set by hand; otherwise it follows from the seed. */
    public boolean isInjected() {
        return header.path("injected").asBoolean(false);
    }

    /** True if it has an end: it was not stopped early, and no state was set by hand before each turn. */
    public boolean isWhole() {
        return !end.get("truncated").asBoolean() && !header.path("injectedEachTurn").asBoolean(false);
    }
}
