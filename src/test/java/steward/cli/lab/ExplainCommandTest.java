package steward.cli.lab;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import steward.cli.Cli;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.Games;
import steward.cli.shared.Streams;
import steward.game.GameSetup;
import steward.scene.Part;
import steward.scene.SceneFiles;
import tools.jackson.databind.JsonNode;

/** {@code steward explain}: the parts of a scene and their prices. */
class ExplainCommandTest {

    /** What each shipped scene needs, and nothing else. */
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
    void withoutPricesItSaysTheSameEveryTime() {
        Cli cli = Cli.run("explain", "duel", "--no-prices");
        assertEquals(cli, Cli.run("explain", "duel", "--no-prices"));
        assertTrue(cli.out().startsWith("""
            Parts of the engine that duel needs, and those left out:

            in   pair impacts       bodies meet, scanOrder descending
            out  walls              no field
            """), cli.out());
    }

    @Test
    void onTheExactRungItSaysWhatExactMeans() {
        String said = "  its decisions are right within a turn; the state is rounded at its end as on every rung:";
        assertTrue(Cli.run("explain", "walled-race", "--no-prices", "--accuracy", "exact").out().contains(said));
        assertFalse(Cli.run("explain", "walled-race", "--no-prices").out().contains(said));
    }

    @Test
    void forProgramsItIsOneObject() {
        JsonNode explained = Cli.run("explain", "duel", "--json", "--no-prices").json();
        assertEquals("duel pod-race 2", explained.get("scene").stringValue() + " "
            + explained.get("game").stringValue() + " " + explained.get("players").intValue());
        assertEquals(14, explained.get("parts").size());
        assertEquals("{\"name\":\"walls\",\"in\":false,\"why\":\"no field\",\"when\":\"physics\"}",
            explained.get("parts").get(1).toString());
        assertEquals("{\"rung\":\"event/official\",\"stated\":true,\"why\":\"as the scene says\"}",
            explained.get("accuracy").toString());
        assertEquals("[]", explained.get("warnings").toString());
    }

    @Test
    void anImpossibleSceneIsRefusedAndAnOddOneWarnedOf(@TempDir Path folder) throws IOException {
        String walled = SceneFiles.load("walled-race").text();
        Path odd = Files.writeString(folder.resolve("odd.json"),
            walled.replace("{ \"x\": 13580, \"y\": 7600 }", "{ \"x\": 16580, \"y\": 7600 }"));
        String warning = odd + ":23:26: race.maps[0].checkpoints[3]: found a checkpoint that no pod can reach at some "
            + "jitter: what counts is behind or under the right wall, expected a place nearer than 600 u to where pods "
            + "can be";
        Cli cli = Cli.run("explain", odd.toString(), "--json", "--no-prices");
        assertEquals("", cli.err());
        assertEquals(warning, cli.json().get("warnings").get(0).stringValue());
        String text = Cli.run("explain", odd.toString(), "--no-prices").out();
        assertTrue(text.startsWith("Warning: ") && text.replaceAll("\\s+", " ").contains(warning), text);
        Cli match = Cli.run("match", "--scene", odd.toString(), "--bot", "builtin:racer", "--bot", "builtin:racer",
            "--no-deadline", "--quiet");
        assertTrue(match.err().startsWith("steward: warning: " + warning + "\n"), match.err());
        assertEquals(match.err().indexOf("warning"), match.err().lastIndexOf("warning"));

        Cli tradeoff = Cli.run("tradeoff", "--quick", "--scene", odd.toString(), "--scene", "nowhere.json");
        assertTrue(tradeoff.err().startsWith("steward: warning: " + warning + "\n"), tradeoff.err());

        Path impossible = Files.writeString(folder.resolve("impossible.json"),
            walled.replace("\"perPlayer\": 2", "\"perPlayer\": 8"));
        Cli refused = Cli.run("explain", impossible.toString());
        assertEquals(ExitStatus.UNUSABLE, refused.status());
        assertTrue(refused.err().startsWith("steward: " + impossible
            + ":22:26: race.maps[0].checkpoints[0]: found pod "), refused.err());
    }

    /** Every part has a price except the broad phase, which would save work. */
    @Test
    @Tag("slow")
    void everyPartHasItsPrice() {
        Cli cli = Cli.run("explain", "mad-pod-racing-silver");
        assertEquals(ExitStatus.DONE, cli.status(), cli.err());
        assertEquals("", cli.err());
        List<String> lines = cli.out().lines().skip(2).takeWhile(line -> !line.isEmpty()).toList();
        assertEquals(14, lines.size(), cli.out());
        for (String line : lines) {
            assertTrue(line.matches("in +<?[0-9]+ ns  [a-z].*|out +\\(<?[0-9]+ ns\\)  [a-z].*"
                + "|in +(-|<)[0-9]+ ns  broad phase .*"), line);
        }
        assertTrue(cli.out().contains("\nA turn takes "), cli.out());
    }

    /**
     * Five rounds are made however slow they are; with a clock that stands still all prices are below the measurable
     * difference.
     */
    @Test
    void onAClockThatStandsStillEverythingIsCheap() {
        ByteArrayOutputStream err = new ByteArrayOutputStream();
        GameSetup setup = Games.open("walled-race");
        long[] wall = new long[1];
        PriceList prices = PriceList.measure(new Streams(new ByteArrayOutputStream(), err, true, true), setup,
            () -> 0, () -> wall[0] += 700_000_000);
        for (Part part : setup.plan().parts()) {
            assertEquals(part.name().equals(Part.BROAD_PHASE) ? "" : part.in() ? "<1 ns" : "(<1 ns)", prices.of(part));
        }
        assertEquals("A turn takes <1 ns here, <1 ns of them to fly straight; the parts add their prices (a broad "
            + "phase saves), those left out would add what is in brackets. Measured now on event/double, medians of 5 "
            + "rounds; < is less than can be told apart.", prices.legend());
        String told = err.toString(StandardCharsets.UTF_8);
        assertTrue(told.startsWith("\rmeasuring prices: 38%") && told.contains("\rmeasuring prices: 100%"), told);
    }

    /** Mean Max had none: its states need not have room for equally many bodies. */
    @ParameterizedTest
    @MethodSource("steward.scene.SceneFiles#shipped")
    void everyShippedSceneHasPrices(String scene) {
        GameSetup setup = Games.open(scene);
        long[] wall = new long[1];
        PriceList prices = PriceList.measure(new Streams(new ByteArrayOutputStream(), new ByteArrayOutputStream(), true,
            true), setup, () -> 0, () -> wall[0] += 700_000_000);
        assertTrue(prices.legend().startsWith("A turn takes <1 ns here"), prices.legend());
        for (Part part : setup.plan().parts()) {
            if (!part.name().equals(Part.BROAD_PHASE)) {
                assertEquals(part.in() ? "<1 ns" : "(<1 ns)", prices.of(part), part.name());
            }
        }
    }
}
