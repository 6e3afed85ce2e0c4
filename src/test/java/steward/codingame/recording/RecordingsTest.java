package steward.codingame.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.TestReporter;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import steward.game.GroundTruth;
import steward.replay.verify.Verification;
import steward.replay.verify.ViewComparison;
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
            compare(all, file, GroundTruth.text(file));
        }
        assertTrue(all.values() > 0, "the folder holds games");
        assertEquals(List.of(), all.differences().stream().limit(20).toList());
    }

    private static void compare(GroundTruth.Report all, Path file, String json) {
        String name = file.getFileName().toString();
        try {
            ImportedRecording recording = ImportedRecording.of(json);
            ViewComparison views = new ViewComparison();
            Verification found = recording.verified(views);
            JsonNode lines = JsonMapper.shared().readTree(json).path("stdin");
            all.add(name, found.turns(), views.values() + lines.size(), recording.difference(found),
                views.notCompared());
        } catch (IllegalArgumentException | DifferentGameException problem) {
            all.add(name, 0, 0, problem.getMessage(), new ArrayList<>());
        }
    }
}
