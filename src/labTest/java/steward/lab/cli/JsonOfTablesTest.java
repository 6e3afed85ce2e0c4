package steward.lab.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.cli.Cli;
import tools.jackson.databind.JsonNode;

/** Each command that prints a table prints it as one JSON object too; some have further tests of their own. */
@Tag("slow")
@Execution(ExecutionMode.CONCURRENT)
class JsonOfTablesTest {

    @TempDir
    private Path folder;

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "scene                                                              | scenes | name, game, players, about",
        "run gas --turns 3 --seed 1                                         | rows   | turn, energy, momentumX",
        "bench --quick --only crowds --bodies 20                           | rows   | section, name, perSecond, ratio"})
    void aTableIsAnArrayOfObjects(String call, String array, String fields) {
        Cli cli = Cli.run(steward.bot.command.CommandLine.split(call + " --json").toArray(String[]::new)).done();
        JsonNode rows = cli.json().get(array);
        assertFalse(rows.isEmpty(), cli.out());
        for (JsonNode row : rows) {
            for (String field : fields.split(", ")) {
                assertTrue(row.has(field), () -> field + ": " + row);
            }
        }
        assertEquals(1, cli.out().lines().count(), cli.out());
    }

    @Test
    @Tag("process")
    void aBotIsCheckedAndALeagueListed() {
        JsonNode check = Cli.run("check", "builtin:racer", "--scene", "duel", "--time-factor", "30", "--json").json();
        assertTrue(check.get("passes").booleanValue(), check.toString());
        assertFalse(check.get("steps").isEmpty());

        String league = folder.resolve("night").toString();
        Cli.run("league", "init", league);
        Cli.run("league", "add", league, "builtin:racer", "builtin:regular");
        JsonNode list = Cli.run("league", "list", league, "--json").json();
        assertEquals("mad-pod-racing", list.get("scene").stringValue());
        assertEquals("builtin:regular", list.get("bots").get(1).get("command").stringValue());
        assertTrue(list.get("bots").get(0).get("versions").isEmpty());
    }

    @Test
    @Tag("process")
    @Tag("campaign")
    void aSceneIsMeasured() {
        JsonNode json = Cli.run("tradeoff", "--quick", "--scene", "grazing", "--json").json();
        assertEquals("grazing", json.get("rows").get(0).get("scene").stringValue());
    }
}
