package steward.cli.explain;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.cli.Cli;
import steward.cli.shared.Games;
import steward.scene.Part;
import steward.scene.SceneFiles;

/** Parts of scenes, and warnings; whole outputs of {@code explain} are golden files. */
class ExplainCommandTest {

    /** Parts that each shipped scene needs, and nothing else. */
    @ParameterizedTest
    @CsvSource({
        "duel, 'pair impacts, minimum impulse, push-out, batch window, drag, velocity rounding, position rounding, "
            + "broad phase, headings, checkpoint sweeps'",
        "mad-pod-racing, 'pair impacts, minimum impulse, push-out, batch window, drag, velocity rounding, "
            + "position rounding, broad phase, headings, checkpoint sweeps'",
        "mad-pod-racing-silver, 'pair impacts, minimum impulse, push-out, batch window, drag, velocity rounding, "
            + "position rounding, broad phase, headings, checkpoint sweeps'",
        "walled-race, 'pair impacts, walls, restitution, minimum impulse, infinite masses, drag, velocity rounding, "
            + "position rounding, headings, checkpoint sweeps'"})
    void aShippedSceneHasExactlyItsParts(String scene, String parts) {
        List<Part> plan = Games.open(scene).plan().parts();
        assertEquals(parts, String.join(", ", plan.stream().filter(Part::in).map(Part::name).toList()));
        assertEquals(14, plan.size());
    }

    @Test
    void onTheExactRungItSaysWhatExactMeans() {
        String said = "  its decisions are right within a turn; the state is rounded at its end as on every rung:";
        assertTrue(Cli.run("explain", "walled-race", "--accuracy", "exact").out().contains(said));
        assertFalse(Cli.run("explain", "walled-race").out().contains(said));
    }

    @Test
    void anImpossibleSceneIsRefusedAndAnOddOneWarnedOf(@TempDir Path folder) throws IOException {
        String walled = SceneFiles.load("walled-race").text();
        Path odd = Files.writeString(folder.resolve("odd.json"),
            walled.replace("{ \"x\": 13580, \"y\": 7600 }", "{ \"x\": 16580, \"y\": 7600 }"));
        String warning = odd + ":24:26: race.maps[0].checkpoints[3]: found a checkpoint that no pod can reach at some "
            + "jitter: what counts is behind or under the right wall, expected a place nearer than 600 u to where pods "
            + "can be";
        Cli cli = Cli.run("explain", odd.toString(), "--json");
        assertEquals("", cli.err());
        assertEquals(warning, cli.json().get("warnings").get(0).stringValue());
        String text = Cli.run("explain", odd.toString()).out();
        assertTrue(text.startsWith("Warning: ") && text.replaceAll("\\s+", " ").contains(warning), text);
        Cli match = Cli.run("match", "--scene", odd.toString(), "--bot", "builtin:racer", "--bot", "builtin:racer",
            "--no-deadline", "--quiet");
        assertTrue(match.err().startsWith("steward: warning: " + warning + "\n"), match.err());
        assertEquals(match.err().indexOf("warning"), match.err().lastIndexOf("warning"));

        Cli tradeoff = Cli.run("tradeoff", "--quick", "--scene", odd.toString(), "--scene", "nowhere.json");
        assertTrue(tradeoff.err().startsWith("steward: warning: " + warning + "\n"), tradeoff.err());

        Path impossible = Files.writeString(folder.resolve("impossible.json"),
            walled.replace("\"perPlayer\": 2", "\"perPlayer\": 8"));
        Cli.run("explain", impossible.toString()).assertRefused("" + impossible
            + ":23:26: race.maps[0].checkpoints[0]: found pod ");
    }
}
