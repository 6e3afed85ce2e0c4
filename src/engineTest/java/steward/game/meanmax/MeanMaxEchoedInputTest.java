package steward.game.meanmax;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;
import steward.game.CodecText;
import steward.game.Comparison;
import steward.game.GroundTruth;
import steward.game.TextCodec;
import steward.game.meanmax.protocol.MeanMaxType;
import steward.scene.SceneFiles;
import steward.scene.SceneReader;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * The lines that the server has sent to bots of Mean Max, as far as a bot echoes them to its standard error: speeds
 * after friction and masses, which the server's views do not show.
 */
class MeanMaxEchoedInputTest {

    @Test
    void whatBotsEchoOfTheirInputIsOurs(TestReporter report) throws IOException {
        GroundTruth.Report all = new GroundTruth.Report(report, "mean-max, input");
        for (Path file : GroundTruth.RECORDINGS.files("mean-max", ".json.gz")) {
            Comparison comparison = new Comparison(file.getFileName().toString());
            int turns = compare(file, comparison);
            all.add(file.getFileName().toString(), turns, comparison.values(),
                comparison.differences().stream().findFirst().orElse(null), List.of());
        }
        assertEquals(List.of(), all.differences().stream().limit(20).toList());
    }

    private static int compare(Path file, Comparison comparison) throws IOException {
        JsonNode json = JsonMapper.shared().readTree(GroundTruth.text(file)).get("success");
        MeanMaxType.MeanMaxSetup setup = new MeanMaxType().open(SceneReader.read(SceneFiles.load("mean-max"), null));
        MeanMax game = setup.create(Long.parseLong(json.get("refereeInput").asString().strip()
            .substring("seed=".length())));
        TextCodec lines = setup.textCodec(game).orElseThrow();
        for (JsonNode frame : json.get("frames")) {
            int player = frame.get("agentId").asInt();
            if (player < 0) {
                continue;
            }
            compareEcho(game, lines, player, frame.path("stderr").asString(""), comparison);
            assertNull(CodecText.read(lines, player, frame.get("stdout").asString().strip()), "the answer is good");
            if (player == game.players() - 1) {
                game.play();
            }
        }
        return game.turn();
    }

    /** Bots that echo their input print a whole mass without its fraction. */
    private static void compareEcho(MeanMax game, TextCodec lines, int player, String echoed, Comparison comparison) {
        List<String> found = CodecText.turn(lines, player).lines()
            .map(line -> line.replaceFirst("(\\d)\\.0 ", "$1 ")).toList();
        List<String> recorded = echoed.lines().toList();
        if (recorded.size() >= found.size() && recorded.get(0).equals(found.get(0))) {
            for (int line = 0; line < found.size(); line++) {
                comparison.same("turn " + (game.turn() + 1) + " input of " + player + " line " + line,
                    recorded.get(line), found.get(line));
            }
        }
    }
}
