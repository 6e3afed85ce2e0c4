package steward.guest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import steward.bot.command.ProgramFinder;
import steward.bot.isolation.Isolation;
import steward.cli.Cli;

/** The page about a contest of today, walked with a small game of ours: its calls as they stand there, in order. */
@Tag("process")
@Tag("campaign")
@Timeout(300)
class ContestDayTest {

    private static final Path PAGE = Path.of("docs/contest-day.md");

    @TempDir
    private Path folder;

    /** The calls of the page behind the word {@code steward}. */
    private static List<List<String>> calls() throws IOException {
        return Files.readAllLines(PAGE).stream().filter(line -> line.startsWith("    steward "))
            .map(line -> Arrays.asList(line.strip().split(" ")).subList(1, line.strip().split(" ").length)).toList();
    }

    @Test
    void itsCallsLeadFromTheProjectToALeague() throws IOException {
        assumeTrue(ProgramFinder.find("sh") != null, "skipped: there is no sh");
        List<List<String>> calls = calls();
        assertEquals("adopt", calls.get(0).get(0));
        List<String> told = new ArrayList<>();
        Path project = folder.resolve("project");
        StandInProject.compiled(Files.createDirectories(project));
        Path scene = Files.writeString(folder.resolve("exotec.json"), Adoption.scene(project, null, null, "exotec",
            Isolation::usual, told::add).json());
        String page = Files.readString(PAGE);
        told.forEach(line -> assertTrue(page.contains("\n" + line.substring(0, line.indexOf(':') + 1)), line));
        Map<String, String> words = Map.of("exotec.json", scene.toString(), "games", folder.resolve("games").toString(),
            "night", folder.resolve("night").toString(), "night.html", folder.resolve("night.html").toString(),
            "./mine", bot("mine", "1"), "./other", bot("other", "2"), "./new", bot("new", "5"));
        List<String> outputs = new ArrayList<>();
        for (List<String> call : calls.subList(1, calls.size())) {
            Cli cli = Cli.run(call.stream().map(word -> words.getOrDefault(word.replace("codingame:./", "./"), word))
                .toArray(String[]::new));
            assertEquals(0, cli.status(), call + ": " + cli.out() + cli.err());
            outputs.add(cli.out());
        }
        StandInProject.end();
        assertTrue(outputs.get(0).contains("games of exotec"), outputs.get(0));
        assertTrue(outputs.get(1).contains("H1 is accepted: new is better"), outputs.get(1));
        assertTrue(Files.size(folder.resolve("night.html")) > 0, outputs.toString());
    }

    private String bot(String name, String word) throws IOException {
        return StandInProject.bot(folder, name, word);
    }
}
