package steward.cli.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import steward.cli.Cli;
import steward.cli.shared.ExitStatus;
import steward.scene.SceneFiles;

/** {@code steward scene}: shipped scenes and the JSON Schema, as they are in the program. */
class SceneCommandTest {

    @Test
    void itListsWhatTheManualLists() throws IOException {
        String readme = Files.readString(Path.of("docs/scenes.md"));
        List<String> lines = Cli.run("scene").out().lines().toList();
        assertEquals(SceneFiles.shipped().size(), lines.size());
        for (String line : lines) {
            String[] parts = line.split(" {2,}", 2);
            assertTrue(SceneFiles.shipped().contains(parts[0]), line);
            assertTrue(readme.contains("| `" + parts[0] + "` | " + parts[1] + " |\n"), line);
            assertTrue(line.length() <= 100, line);
        }
    }

    @Test
    void itPrintsASceneByteForByte() throws IOException {
        for (String name : SceneFiles.shipped()) {
            Cli cli = Cli.run("scene", name).done();
            assertEquals(Files.readString(Path.of("config/scenes", name + ".json")), cli.out());
        }
    }

    /** {@code steward scene duel | steward explain -}. */
    @Test
    void aSceneIsTakenFromTheStandardInput() {
        String duel = Cli.run("scene", "duel").out();
        assertEquals(Cli.run("explain", "duel").out(), explained(duel, ExitStatus.DONE));
        String refusal = explained("{ }}", ExitStatus.UNUSABLE);
        assertTrue(refusal.startsWith("steward: standard input:1:"), refusal);
    }

    private static String explained(String scene, int status) {
        Cli cli = Cli.piped(scene.getBytes(StandardCharsets.UTF_8), "explain", "-");
        assertEquals(status, cli.status());
        return cli.out() + cli.err();
    }

    @Test
    void itPrintsTheSchema() throws IOException {
        String schema = Files.readString(Path.of("build/schemas/pod-race.json"));
        assertEquals(schema, Cli.run("scene", "--schema").out());
        assertEquals(schema, Cli.run("scene", "duel", "--schema").out());
    }
}
