package steward.cli.tournament;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.cli.Cli;
import steward.files.InputException;
import tools.jackson.databind.JsonNode;

/** A folder of programs, some of which fail, becomes a table and a page for each author. */
@Execution(ExecutionMode.CONCURRENT)
class TournamentTest {

    @TempDir
    private Path folder;

    @Test
    void namesKeepLettersOfAnyLanguageAndAreUnlike() throws IOException {
        Path in = Files.createDirectory(folder.resolve("names"));
        for (String name : List.of("Jo\u0308rg Mu\u0308ller.py", "a b.py", "a+b.js", "tune.x.py", "+.java", "notes.txt",
                ".hidden.py")) {
            Files.createFile(in.resolve(name));
        }
        Programs programs = Programs.in(in, folder);
        assertEquals(List.of("bot", "J\u00f6rg-M\u00fcller", "a-b", "a-b-2", "tune-x"),
            programs.programs().stream().map(Programs.Program::name).toList());
        assertEquals(List.of("notes.txt"), programs.others());
    }

    @Test
    void aFolderWithoutProgramsIsRefused() throws IOException {
        Path in = Files.createDirectory(folder.resolve("none"));
        assertThrows(InputException.class, () -> Programs.in(in, folder));
        assertThrows(InputException.class, () -> Programs.in(folder.resolve("gone"), folder));
    }

    /** Three pairs of the three that can run, two games each: 6. The C++ program is no C++, with a compiler or none. */
    @Test
    @Tag("process")
    @Tag("slow")
    @Timeout(300)
    void everybodyMeetsEverybodyAndWhoFailsStopsNobody() throws IOException {
        ProgramFolder programs = new ProgramFolder(folder, 8);
        programs.add("J\u00f6rg M\u00fcller", "1", "");
        Files.writeString(folder.resolve("in/J\u00f6rg M\u00fcller/run"), "sh main.sh\r\n");
        programs.add("\u5c0f\u660e", "9000", "");
        programs.add("crash", "1", "");
        Files.writeString(folder.resolve("in/crash/run"), "sh -c 'read -r setup; echo oh no >&2; exit 3'");
        Files.writeString(folder.resolve("in/broken.cpp"), "int main() { return <b>; }\n");
        Cli first = programs.call("--games", "1").done();
        assertTrue(first.out().contains("6 games in this run"), first.out());
        assertTrue(first.err().contains("broken: cannot run: the compiler failed: bot.cpp:1:")
            || first.err().contains("broken: cannot run: there is no C++ compiler"), first.err());
        String crash = Files.readString(folder.resolve("out/bots/crash.html"));
        assertTrue(crash.contains("exited with status 3 before answering") && crash.contains("oh no")
            && crash.contains("failed in 4 games"), crash);
        String good = Files.readString(folder.resolve("out/bots/J\u00f6rg-M\u00fcller.html"));
        assertTrue(good.contains("It is ready") && good.contains("&quot;thrust&quot;:100"), good);
        assertFalse(Files.readString(folder.resolve("out/bots/broken.html")).contains("<b>"));
        List<String> table = Files.readAllLines(folder.resolve("out/table.csv"));
        assertEquals(4, table.size(), "heads and three bots");
        assertTrue(table.get(0).endsWith(",turnsMean,turnsDeviation") && table.get(0).contains(",lapsMean,"),
            table.get(0));
        assertEquals(table.get(0).split(",", -1).length, table.get(1).split(",", -1).length);
        assertTrue(Files.readString(folder.resolve("out/index.html")).contains("league.html"));
        Cli again = programs.call("--games", "1");
        assertTrue(again.out().contains("0 games in this run"), again.out() + again.err());

        JsonNode json = programs.call("--games", "1", "--json").done().json();
        assertEquals(4, json.get("programs").size());
        assertEquals(3, json.get("bots").size(), json.toString());
        for (JsonNode program : json.get("programs")) {
            assertEquals(program.get("standing").stringValue().equals("is ready"), program.get("ready").booleanValue());
        }
    }
}
