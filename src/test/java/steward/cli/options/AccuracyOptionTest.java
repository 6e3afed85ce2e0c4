package steward.cli.options;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.cli.Cli;
import steward.cli.ShellBots;
import steward.cli.shared.ExitStatus;
import steward.scene.SceneFiles;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** {@code --accuracy RUNG} in place of what the scene says. */
@Timeout(60)
class AccuracyOptionTest {

    @TempDir
    private Path folder;

    /** Two pods that meet in the middle of the way, so that the rung matters. */
    private Cli duel(Path file, String... more) {
        ShellBots bots = new ShellBots(folder);
        return Cli.run(List.of("match", "--scene", "duel", "--no-deadline", "--seed", "7",
            "--bot", bots.driver("a", "5500 3000"), "--bot", bots.driver("b", "5500 3000"), "--out", file.toString()),
            more).done();
    }

    private static JsonNode scene(Path replay) throws IOException {
        try (var lines = Files.lines(replay)) {
            return JsonMapper.shared().readTree(lines.findFirst().get()).get("scene");
        }
    }

    private static String states(Path replay) throws IOException {
        try (var lines = Files.lines(replay)) {
            return lines.skip(1).map(line -> JsonMapper.shared().readTree(line))
                .filter(line -> line.has("outcome")).map(line -> line.get("outcome").get("hash").toString())
                .toList().toString();
        }
    }

    @ParameterizedTest
    @Tag("process")
    @CsvSource({
        "exact, '{\"advance\":\"event\",\"arithmetic\":\"exact\"}'",
        "event/compensated, '{\"advance\":\"event\",\"arithmetic\":\"compensated\"}'",
        "step/4, '{\"advance\":\"step\",\"steps\":4,\"arithmetic\":\"double\"}'"})
    void aReplayHoldsTheRungAndVerifies(String rung, String block) throws IOException {
        Path file = folder.resolve("x.jsonl");
        duel(file, "--accuracy", rung);
        JsonNode used = scene(file);
        assertEquals(block, used.get("accuracy").toString());
        JsonNode own = JsonMapper.shared().readTree(SceneFiles.load("duel").text());
        assertEquals(List.copyOf(own.propertyNames()), List.copyOf(used.propertyNames()));
        for (String name : own.propertyNames()) {
            assertTrue(name.equals("accuracy") || own.get(name).equals(used.get(name)), name);
        }
        assertTrue(Cli.run("replay", file.toString(), "--verify").out().startsWith("verified: "));
    }

    @Test
    @Tag("process")
    void steppingIsAnotherGameThanTheOfficialOne() throws IOException {
        Path own = folder.resolve("own.jsonl");
        Path official = folder.resolve("official.jsonl");
        Path rough = folder.resolve("rough.jsonl");
        duel(own);
        duel(official, "--accuracy", "event/official");
        duel(rough, "--accuracy=step/1");
        assertEquals(states(own), states(official));
        assertNotEquals(states(own), states(rough));
    }

    @Test
    void explainSaysWhichRungAndWhy() {
        assertTrue(Cli.run("explain", "duel").out()
            .contains("\nAccuracy: event/official, as the scene says\n"));
        String out = Cli.run("--cli", "explain duel --accuracy step/2").out();
        assertTrue(out.contains("\nAccuracy: step/2, as the call says; the scene's own is event/official\n"), out);
        assertTrue(out.contains("\n  accuracy: advance step, steps 2, arithmetic double\n"), out);
    }

    @Test
    void aSceneWithMistakesIsRefusedWithItsOwnPlaces() throws IOException {
        Path file = Files.writeString(folder.resolve("s.json"), SceneFiles.load("duel").text()
            .replace("\"official\"", "\"official\", \"stepps\": 3"));
        Cli cli = Cli.run("explain", file.toString(), "--accuracy", "exact");
        assertEquals(ExitStatus.UNUSABLE, cli.status());
        assertTrue(cli.err().contains(file + ":25:") && cli.err().contains("accuracy.stepps: found an unknown field"),
            cli.err());
    }
}
