package steward.game.podrace.vectors;

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
import steward.game.podrace.PodRace;
import steward.game.podrace.protocol.PodRaceType;
import steward.scene.SceneFiles;
import steward.scene.SceneReader;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * One match of the published referee, recorded turn by turn at full precision.
 *
 * @param name   of its file
 * @param header what was played
 * @param start  the state before the first turn
 * @param turns  one by one
 * @param end    how it ended
 */
record VectorMatch(String name, JsonNode header, JsonNode start, List<JsonNode> turns, JsonNode end) {

    static VectorMatch read(Path file) {
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

    int players() {
        return header.get("players").asInt();
    }

    int podsPerPlayer() {
        return header.get("podsPerPlayer").asInt();
    }

    double[][] checkpoints() {
        JsonNode places = header.get("checkpoints");
        double[][] checkpoints = new double[places.size()][];
        for (int k = 0; k < checkpoints.length; k++) {
            checkpoints[k] = new double[] {places.get(k).get(0).asDouble(), places.get(k).get(1).asDouble()};
        }
        return checkpoints;
    }

    /** True if a state was set by hand before every turn. */
    boolean isTurnByTurn() {
        return header.get("injectedEachTurn").asBoolean();
    }

    /** The official scene with this match's numbers and the rules of the contest, lines too. */
    PodRaceType.PodRaceSetup setup() {
        String scene = SceneFiles.load("mad-pod-racing").text()
            .replace("\"rules\": \"live\"", "\"rules\": \"contest\", \"commands\": \"site\"")
            .replace("\"players\": 2", "\"players\": " + players())
            .replace("\"perPlayer\": 2", "\"perPlayer\": " + podsPerPlayer())
            .replace("\"laps\": 3", "\"laps\": " + header.get("laps").asInt())
            .replace("\"turnsWithoutCheckpoint\": 100",
                "\"turnsWithoutCheckpoint\": " + header.get("turnsWithoutCheckpoint").asInt())
            .replace("\"maximumTurns\": 500", "\"maximumTurns\": " + header.get("maximumTurns").asInt());
        return new PodRaceType().open(SceneReader.read(scene, name));
    }

    PodRace race() {
        return setup().create(checkpoints());
    }
}
