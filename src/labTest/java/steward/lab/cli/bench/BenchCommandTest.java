package steward.lab.cli.bench;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.cli.Cli;
import steward.lab.bench.Section;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * Output, files and refusals of {@code steward bench}; no test depends on how fast anything is. It takes long because
 * a measurement warms up and repeats, however small it is.
 */
@Execution(ExecutionMode.CONCURRENT)
class BenchCommandTest {

    @TempDir
    private Path folder;

    @Test
    @Tag("slow")
    void theSameRowsInTheTableAndInTheFiles() throws IOException {
        Cli cli = Cli.run("bench", "--quick", "--only", "crowds", "--bodies", "20", "--only", "verify", "--out",
            folder.resolve("out").toString());

        assertEquals(0, cli.status(), cli.err());
        List<String> csv = Files.readAllLines(folder.resolve("out/bench.csv"));
        JsonNode rows = JsonMapper.shared().readTree(Files.readString(folder.resolve("out/bench.json"))).get("rows");
        assertEquals(6, rows.size());
        assertEquals(7, csv.size());
        String page = Files.readString(folder.resolve("out/performance.md"));
        for (int k = 0; k < rows.size(); k++) {
            String name = rows.get(k).get("name").stringValue();
            assertTrue(csv.get(k + 1).contains("\"" + name + "\""), name);
            assertTrue(cli.out().contains("  " + name), name);
            assertTrue(page.contains("| " + name + " |"), name);
            assertTrue(rows.get(k).get("perSecond").doubleValue() > 0, name);
        }
    }

    @Test
    void whatIsThereStays() throws IOException {
        Files.writeString(folder.resolve("bench.json"), "mine");
        Cli cli = Cli.run("bench", "--quick", "--only", "verify", "--out", folder.toString());

        assertEquals(2, cli.status());
        assertTrue(cli.err().contains("exists already"), cli.err());
        assertEquals("mine", Files.readString(folder.resolve("bench.json")));
        assertEquals("", cli.out(), "nothing was measured before");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "--bodies 0         | --bodies: found 0, expected 1 to 10000000",
        "--bodies 20000000  | --bodies: found 20000000, expected 1 to 10000000",
        "--only crowd       | did you mean 'crowds'?",
        "--quick --long     | --long and --quick exclude each other",
        "--overwrite        | --overwrite: expected --out",
        "--out /dev/null/x  | /dev/null"})
    void badInputIsRefusedBeforeAnyWork(String words, String said) {
        Cli cli = Cli.run(("bench " + words).split(" "));

        assertEquals(2, cli.status());
        assertTrue(cli.err().contains(said), cli.err());
        assertEquals("", cli.out());
    }

    @Test
    void aToolThatIsNotThereIsNamed() {
        Cli cli = Cli.run("bench", "--quick", "--only", "tools", "--tools", folder.toString());

        assertEquals(1, cli.status());
        assertEquals("steward: tools: could not be measured: found no " + folder.resolve("cg-brutaltester.jar"),
            cli.err().strip());
    }

    @Test
    void theNamesThatAreCompletedAreThoseOfTheParts() {
        assertEquals(BenchCommand.Parts.ALL,
            BenchSuite.all(List.of(1), folder).stream().map(Section::name).toList());
    }
}
