package steward.codingame.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.zip.GZIPInputStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.TestReporter;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import steward.game.GroundTruth;
import steward.match.TestScenes;
import steward.replay.verify.Verification;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * Games of the server, imported and verified: all JSON in the folder of each game. Each file is reported with what was
 * compared, so that {@code ./gradlew test --tests '*RecordingsTest' -Psteward.recordings=FOLDER} judges any folder.
 */
@Execution(ExecutionMode.CONCURRENT)
class RecordingsTest {

    @ParameterizedTest
    @ValueSource(strings = {"pod-race", "mean-max", "poker-chip-race", "fantastic-bits", "search-race"})
    @Tag("slow")
    void everyGameOfTheServerVerifies(String game, TestReporter report) throws IOException {
        GroundTruth.Report all = new GroundTruth.Report(report, game);
        for (Path file : GroundTruth.RECORDINGS.files(game, ".json", ".json.gz")) {
            compare(all, file, text(file));
        }
        assertTrue(all.values() > 0, "the folder holds games");
        assertEquals(List.of(), all.differences().stream().limit(20).toList());
    }

    private static String text(Path file) throws IOException {
        try (InputStream in = Files.newInputStream(file);
             InputStream of = file.toString().endsWith(".gz") ? new GZIPInputStream(in) : in) {
            return new String(of.readAllBytes(), StandardCharsets.UTF_8);
        }
    }

    private static void compare(GroundTruth.Report all, Path file, String json) {
        String name = file.getFileName().toString();
        ByteArrayOutputStream replay = new ByteArrayOutputStream();
        try {
            RecordingImport.Imported imported = RecordingImport.of(json, name, TestScenes.TYPES).write(replay);
            Verification found = TextMatches.verify(replay.toByteArray());
            JsonNode lines = JsonMapper.shared().readTree(json).path("stdin");
            String difference = found.difference() != null ? found.difference().toString()
                : imported.turns() == found.turns() ? null : found.turns() + " turns verified of " + imported.turns();
            all.add(name, found.turns(), found.views().values() + lines.size(), difference,
                found.views().notCompared());
        } catch (IllegalArgumentException | DifferentGameException problem) {
            all.add(name, 0, 0, problem.getMessage(), new ArrayList<>());
        } catch (InterruptedException nobodyDoes) {
            throw new AssertionError(nobodyDoes);
        }
    }
}
