package steward.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import steward.cli.shared.ExitStatus;
import steward.scene.SceneFiles;

/** The program as a whole: help, version, completion, and how a call is taken apart. */
class MainTest {

    @Test
    void withoutACommandItPrintsItsHelp() {
        Cli cli = Cli.run();
        assertEquals(ExitStatus.DONE, cli.status());
        assertTrue(cli.out().startsWith("Usage: steward"), cli.out());
        assertEquals(cli.out(), Cli.run("--help").out());
    }

    @ParameterizedTest
    @ValueSource(strings = {"match", "replay", "feed", "explain", "demo", "simulate", "import", "stability",
        "completion"})
    void everyCommandHasHelpWithAnExampleAndAVersion(String command) {
        Cli help = Cli.run(command, "--help");
        assertEquals(ExitStatus.DONE, help.status());
        assertTrue(help.out().contains("Usage: steward " + command), help.out());
        int example = help.out().indexOf("\nExample");
        assertTrue(example > 0 && help.out().indexOf("steward " + command, example) > 0, help.out());
        assertTrue(help.out().lines().allMatch(line -> line.length() <= 100), help.out());
        assertEquals(ExitStatus.DONE, Cli.run(command, "--version").status());
        assertTrue(Cli.run("--help").out().contains("  " + command + " "));
    }

    @Test
    void versionNamesTheProgram() {
        assertTrue(Cli.run("--version").out().startsWith("steward "));
        assertEquals(Cli.run("--version").out(), Cli.run("match", "--version").out());
    }

    @Test
    void aWholeCommandLineIsSplitAsAShellWould() {
        Cli cli = Cli.run("--cli", "replay 'a file' --quiet");
        assertEquals(ExitStatus.UNUSABLE, cli.status());
        assertEquals("steward: a file: found no such file, expected a replay\n", cli.err());
        assertEquals(Cli.run().out(), Cli.run("--cli", " ").out());
    }

    @Test
    void anUnclosedQuoteOfAWholeCommandLineIsLocated() {
        Cli cli = Cli.run("--cli", "replay 'a file");
        assertEquals(ExitStatus.UNUSABLE, cli.status());
        assertEquals("steward: --cli, column 8: the single quote is never closed\n", cli.err());
    }

    @Test
    void misspeltWordsSuggestTheNearest() {
        assertTrue(Cli.run("mach").err().contains("steward match"));
        assertTrue(Cli.run("replay", "x", "--verfy").err().contains("--verify"));
        assertEquals(ExitStatus.UNUSABLE, Cli.run("mach").status());
        assertEquals(ExitStatus.UNUSABLE, Cli.run("replay", "x", "--verfy").status());
    }

    @Test
    void argumentsThatBeginWithAnAtSignAreNoFiles() {
        assertEquals("steward: @x: found no such file, expected a replay\n", Cli.run("replay", "@x").err());
    }

    @Test
    @Tag("process")
    void completionIsAScriptThatBashTakes(@TempDir Path folder) throws IOException, InterruptedException {
        assumeTrue(Files.isExecutable(Path.of("/bin/bash")), "there is no bash");
        Cli cli = Cli.run("completion");
        assertEquals(ExitStatus.DONE, cli.status());
        Path script = Files.writeString(folder.resolve("completion"), cli.out());
        assertEquals(0, new ProcessBuilder("/bin/bash", "-n", script.toString()).inheritIO().start().waitFor());
        assertTrue(cli.out().contains("--no-deadline") && cli.out().contains("mad-pod-racing"), cli.out());
    }

    @Test
    void explainTakesEveryShippedScene() {
        for (String scene : SceneFiles.shipped()) {
            Cli cli = Cli.run("explain", scene, "--no-prices");
            assertEquals(ExitStatus.DONE, cli.status(), cli.err());
            assertTrue(cli.out().lines().allMatch(line -> line.length() <= 100), cli.out());
        }
    }

    @Test
    void explainTellsThePartsAndTheSettings() {
        Cli cli = Cli.run("explain", "walled-race", "--no-prices");
        assertEquals(ExitStatus.DONE, cli.status());
        assertTrue(cli.out().lines().anyMatch(line -> line.matches("in +walls +4 walls")), cli.out());
        assertTrue(cli.out().lines().anyMatch(line -> line.matches("out +reactions .*")), cli.out());
        assertTrue(cli.out().contains("  pods: perPlayer 2, radius 400, mass 1, restitution 0.9\n"), cli.out());
        assertTrue(cli.out().lines().allMatch(line -> line.length() <= 100), cli.out());
    }
}
