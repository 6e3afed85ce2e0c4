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
import org.junit.jupiter.params.provider.MethodSource;
import steward.cli.Cli;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.Games;
import steward.game.GameSetup;
import steward.scene.Part;
import steward.scene.SceneFiles;
import steward.scene.SceneKey;
import steward.scene.price.MeasuredPrices;
import steward.scene.price.PartPrice;
import steward.scene.price.StoredPartPrices;
import tools.jackson.databind.JsonNode;

/** {@code steward explain}: the parts of a scene and their prices. */
class ExplainCommandTest {

    /** The shipped scenes whose parts have stored prices: those of games between players. */
    static List<String> priced() {
        return SceneFiles.shipped().stream().filter(name -> Games.open(name).scene().players() > 0).toList();
    }

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
        String warning = odd + ":24:26: race.maps[0].checkpoints[3]: found a checkpoint that no pod can reach at some "
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
            + ":23:26: race.maps[0].checkpoints[0]: found pod "), refused.err());
    }

    /** At once, from what was measured once: each scene's own shares; every part that has been measured has one. */
    @ParameterizedTest
    @MethodSource("priced")
    void aShippedSceneHasItsStoredShares(String scene) {
        Cli cli = Cli.run("explain", scene);
        assertEquals(ExitStatus.DONE, cli.status(), cli.err());
        List<Part> parts = Games.open(scene).plan().parts();
        List<String> lines = cli.out().lines().filter(line -> line.matches("(in|out) .*")).toList();
        assertEquals(parts.size(), lines.size(), cli.out());
        for (String line : lines) {
            assertTrue(line.matches("in +<?-?[0-9]+%  [a-z].*|out +\\(<?-?[0-9]+%\\)  [a-z].*|out +broad phase .*"),
                line);
        }
        String told = cli.out().replaceAll("\\s+", " ");
        assertTrue(told.matches(".* Stored for " + scene + " on event/(official|double), measured 20[0-9-]{8}: .* "
            + "JDK .*"), told);
    }

    /** The file is of the scenes as they are: a change of a scene or of its parts needs new figures. */
    @ParameterizedTest
    @MethodSource("priced")
    void theStoredSharesAreOfTheScenesAsTheyAre(String scene) {
        GameSetup setup = Games.open(scene);
        List<StoredPartPrices.Row> rows = StoredPartPrices.all().stream().filter(row -> row.scene().equals(scene))
            .toList();
        for (StoredPartPrices.Row row : rows) {
            assertEquals(SceneKey.of(setup.scene()), row.key(), "made by steward tradeoff --parts");
            assertEquals(setup.scene().accuracy().text(), row.rung());
            assertEquals(setup.scene().gameId(), row.game());
        }
        for (Part part : setup.plan().parts()) {
            boolean measured = rows.stream().anyMatch(row -> row.part().equals(part.name()) && row.in() == part.in());
            assertEquals(part.in() || !part.name().equals(Part.BROAD_PHASE), measured, scene + ": " + part.name());
        }
    }

    /** A scene of one's own: the medians of the shipped scenes of its game. */
    @Test
    void anotherSceneHasTheSharesOfItsGame(@TempDir Path folder) throws IOException {
        Path mine = Files.writeString(folder.resolve("mine.json"),
            SceneFiles.load("duel").text().replace("\"laps\": 1", "\"laps\": 2"));
        String told = Cli.run("explain", mine.toString()).out().replaceAll("\\s+", " ");
        assertTrue(told.contains("Stored, the medians of duel, mad-pod-racing-silver, mad-pod-racing, walled-race on "
            + "event/official, event/double, measured "), told);
        JsonNode json = Cli.run("explain", mine.toString(), "--json").json();
        assertTrue(json.get("parts").get(0).get("shareOfTurn").isNumber(), json.toString());
    }

    /** Made-up prices: in nanoseconds, in brackets for a part that is left out, and no less than can be told apart. */
    @Test
    void measuredPricesAreToldInNanoseconds() {
        GameSetup setup = Games.open("duel");
        Part in = setup.plan().parts().get(0);
        Part out = setup.plan().parts().get(1);
        PriceList prices = PriceList.measured(setup, new MeasuredPrices(List.of(
            new PartPrice(PartPrice.EMPTY, true, 20, 0), new PartPrice(in.name(), true, 150.4, 2),
            new PartPrice(out.name(), false, 3, 5)), new PartPrice("", true, 400, 0), 7));
        assertEquals("150 ns", prices.of(in));
        assertEquals("(<5 ns)", prices.of(out));
        assertEquals("", prices.of(setup.plan().parts().get(2)));
        assertTrue(prices.legend().matches("A turn takes 400 ns here, 20 ns of them .* Measured now on "
            + "event/official, .* of 7 rounds; .*"), prices.legend());
    }

    @Test
    void measuringAndLeavingOutContradictEachOther() {
        Cli.run("explain", "duel", "--measure", "--no-prices").assertRefused("--measure: found --no-prices with it");
    }
}
