package steward.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import steward.bot.command.BuiltinBots;
import steward.cli.shared.ExitStatus;
import steward.scene.SceneFiles;

/** The program as a whole: help, version, completion, and how a call is taken apart. */
class MainTest {

    @TempDir
    private static Path shared;
    private static String help;
    private static Path completion;

    @BeforeAll
    static void printHelpAndCompletion() throws IOException {
        help = Cli.run("--help").out();
        completion = Files.writeString(shared.resolve("completion"), Cli.run("completion").done().out());
    }

    @Test
    void withoutACommandItPrintsItsHelp() {
        Cli cli = Cli.run().done();
        assertTrue(cli.out().startsWith("Usage: steward"), cli.out());
        assertEquals(cli.out(), help);
    }

    @ParameterizedTest
    @MethodSource("steward.cli.Main#commands")
    void everyCommandIsListedAndHasAVersion(String command) {
        assertEquals(ExitStatus.DONE, Cli.run(command, "--version").status());
        assertTrue(help.contains("  " + command + " "));
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
    void argumentsThatBeginWithAnAtSignAreNoFiles() {
        assertEquals("steward: @x: found no such file, expected a replay\n", Cli.run("replay", "@x").err());
    }

    @Test
    @Tag("process")
    void completionIsAScriptThatBashTakes() throws IOException, InterruptedException {
        assumeTrue(Files.isExecutable(Path.of("/bin/bash")), "there is no bash");
        assertEquals(0, new ProcessBuilder("/bin/bash", "-n", completion.toString()).inheritIO().start().waitFor());
        String script = Files.readString(completion);
        for (String word : List.of("--no-deadline", "mad-pod-racing", "builtin:veteran", "codingame", "compensated",
            "crowds", "dense-box", "failed", "python")) {
            assertTrue(script.contains(word), word);
        }
    }

    /** As bash calls it: the words of the line, which it has parted at colons and equals signs too. */
    @ParameterizedTest
    @Tag("process")
    @CsvSource(delimiter = '|', value = {
        "steward expl | explain", "steward help ma | match", "steward key n | new", "steward new p | python",
        "steward match --protocol c | codingame", "steward match --accuracy c | compensated",
        "steward match --accuracy = off | official", "steward match --bot bui | builtin:captain builtin:chaser "
        + "builtin:coaster builtin:contender builtin:driver builtin:gatherer builtin:glutton builtin:grazer "
        + "builtin:harvester builtin:marauder builtin:nibbler builtin:planner builtin:racer builtin:regular "
        + "builtin:striker builtin:veteran",
        "steward match --bot builtin : ve | veteran",
        "steward match --bot me = builtin : ra | racer", "steward match --scene w | walled-race",
        "steward match --keep f | failed", "steward match --threads a | auto",
        "steward bench --only cr | crowds", "steward tradeoff --scene w | walled-race",
        "steward scene du | duel", "steward explain du | duel",
        "steward demo --accuracy do | double", "steward play --json-league builtin : v | veteran",
        "steward referee -p1 builtin : v | veteran", "steward feed x --player 0 -- builtin : v | veteran",
        "steward feed x --protocol j | json", "steward replay x | "})
    void everyFixedVocabularyIsCompleted(String line, String words) throws IOException, InterruptedException {
        assumeTrue(Files.isExecutable(Path.of("/bin/bash")), "there is no bash");
        assumeTrue(!BuiltinBots.installed().names().isEmpty(), "the builtin bots are not on the class path");
        List<String> call = new ArrayList<>(List.of("/bin/bash", "-c", "source \"$0\"; COMP_WORDS=(\"$@\"); "
            + "COMP_CWORD=$(($# - 1)); _steward_words; echo \"${COMPREPLY[*]}\"", completion.toString()));
        call.addAll(List.of(line.split(" ")));
        Process process = new ProcessBuilder(call).redirectErrorStream(true).start();
        String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertEquals((words == null ? "" : words) + "\n", said);
        assertEquals(0, process.waitFor());
    }

    @Test
    void explainTakesEveryShippedScene() {
        for (String scene : SceneFiles.shipped()) {
            Cli cli = Cli.run("explain", scene).done();
            assertTrue(cli.out().lines().allMatch(line -> line.length() <= 100), cli.out());
        }
    }
}
