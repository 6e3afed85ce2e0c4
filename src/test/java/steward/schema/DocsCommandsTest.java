package steward.schema;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static steward.schema.PageShell.assertContains;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import steward.bot.command.CommandLine;

/**
 * Lines of README and manual, run by a shell as they stand there, in a folder with the bots that they name. Each is
 * found on its page by how it begins. Only time limits are longer than shown: the machine may be busy.
 */
@Tag("process")
@Tag("slow")
@Timeout(300)
class DocsCommandsTest {

    private static final String FENCE = "```\\w*\\R(.*?)```";

    @TempDir
    private Path folder;
    private PageShell shell;

    /** Puts the program and the README's bot into the folder. */
    @BeforeEach
    void prepare() throws IOException {
        PageShell.need("python3");
        shell = new PageShell(folder, """
            case "$1 $*" in
              *--time-factor*) ;;
              match*|referee*|play*) set -- "$@" --time-factor 100 ;;
            esac
            """);
        Files.writeString(folder.resolve("bot.py"), PageShell.fenced("README.md", "```python\\R(.*?)```", 0));
    }

    /** CodinGame's bot of the other tests, as a program of this name. */
    private void textBot(String name) throws IOException {
        Path pilot = Path.of("src/test/resources/codingame/pilot.py").toAbsolutePath();
        shell.executable(name, "exec python3 " + CommandLine.quote(List.of(pilot.toString())) + "\n");
    }

    @Test
    void theReadmesBotPlaysAndItsReplayVerifies() throws IOException, InterruptedException {
        String said = shell.run(0, "README.md", "steward match --bot 'me=python3 bot.py' --bot builtin:racer");
        assertEndsByTheRules(said);
        assertContains("verified: ", shell.run(0, "README.md", "steward replay match.jsonl --verify"));
    }

    @Test
    @Tag("campaign")
    void aReplayCanBeReadInEveryWay() throws IOException, InterruptedException {
        shell.run(0, "README.md", "steward match --bot 'me=python3 bot.py' --bot builtin:racer");
        String said = shell.run(0, "README.md", "steward replay match.jsonl --turn 57");
        assertContains("57", said);
        said = shell.run(0, "docs/replays.md", "steward replay match.jsonl --impacts");
        assertContains("impulse", said);
        said = shell.run(0, "docs/replays.md", "steward replay match.jsonl --frames --player 0");
        assertTrue(said.startsWith("{\"type\":\"setup\","), said);
        shell.run(0, "docs/watching.md", "steward replay match.jsonl --view match.html");
        assertTrue(Files.size(folder.resolve("match.html")) > 10_000);
        said = shell.run(1, "docs/debugging.md", "steward feed match.jsonl --player racer -- builtin:veteran");
        assertContains("differs", said);
    }

    @Test
    @Tag("campaign")
    void aBotOfTheSitePlaysAlsoAsCgBrutaltesterCallsIt() throws IOException, InterruptedException {
        textBot("a.out");
        String said = shell.run(0, "docs/protocol.md", "steward match --bot codingame:./a.out --bot builtin:racer");
        assertEndsByTheRules(said);

        textBot("mine");
        Files.copy(Path.of("src/test/resources/codingame/pilot.py"), folder.resolve("other.py"));
        shell.run(0, "docs/compatibility.md", "steward referee -p1 ./mine");
        assertTrue(Files.exists(folder.resolve("game.json")));
        assertContains("verified: ", shell.runLine(0, "steward replay match.jsonl --verify"));
    }

    @Test
    void theTestOfASimulatorHasTheAnswerThatIsShown() throws IOException, InterruptedException {
        Files.writeString(folder.resolve("tests.txt"), PageShell.fenced("docs/tables/simulate.md", FENCE, 0));
        assertEquals(PageShell.fenced("docs/tables/simulate.md", FENCE, 1),
            shell.run(0, "docs/library.md", "steward simulate < tests.txt"));
    }

    @Test
    @Tag("campaign")
    void aSceneIsExplainedAndAnEnvironmentCanBeLeftBehind() throws IOException, InterruptedException {
        shell.run(0, "docs/scenes.md", "steward scene walled-race > my-scene.json");
        assertContains("\"scene\":\"walled-race\"", shell.run(0, "docs/scenes.md", "steward explain my-scene.json"));

        // No interpreter here: where it is found through variables, as pyenv's may be, an empty environment hides it.
        shell.executable("mine", "test -z \"$AN_OPINION$A_PASSWORD\" || exit 3\nexit 4\n");
        String hidden = PageShell.line("docs/security.md", "env -i ");
        assertContains("exited with status 4", shell.runLine(0, "AN_OPINION=own " + hidden));
        String open = hidden.substring(hidden.indexOf("steward match"));
        assertContains("exited with status 3", shell.runLine(0, "AN_OPINION=own " + open));
        assertContains("exited with status 4", shell.runLine(0, "A_PASSWORD=secret " + open));
    }

    /** Expects a race decided by the rules: the line names no seed, so on the map that is drawn either may win. */
    private static void assertEndsByTheRules(String said) {
        assertTrue(Pattern.compile("finished after 3 laps|is out: no checkpoint in 101 turns").matcher(said).find(),
            () -> "expected a race that ends by the rules, found:\n" + said);
    }

    @Test
    void aLineThatFailsIsFound() throws IOException {
        Files.writeString(folder.resolve("match.jsonl"), "no replay\n");
        assertThrows(AssertionError.class, () -> shell.run(0, "README.md", "steward replay match.jsonl --verify"));
        assertThrows(AssertionError.class, () -> PageShell.line("README.md", "steward nothing"));
    }
}
