package steward.schema;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import steward.bot.command.CommandLine;
import steward.cli.Main;

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

    /** Puts the program and the README's bot into the folder. */
    @BeforeEach
    void prepare() throws IOException {
        assumeTrue(isThere("sh"), "skipped: there is no sh");
        assumeTrue(isThere("python3"), "skipped: there is no python3 on the PATH");
        String java = Path.of(System.getProperty("java.home"), "bin", "java").toString();
        String program = CommandLine.quote(List.of(java, "-XX:TieredStopAtLevel=1", "-cp",
            System.getProperty("java.class.path"), Main.class.getName()));
        executable("bin/steward", """
            case "$1 $*" in
              *--time-factor*) ;;
              match*|referee*|play*) set -- "$@" --time-factor 100 ;;
            esac
            exec %s "$@"
            """.formatted(program));
        Files.writeString(folder.resolve("bot.py"), fenced("README.md", "```python\\R(.*?)```", 0));
    }

    private static boolean isThere(String program) {
        try {
            return new ProcessBuilder(program, "-c", "").start().waitFor() == 0;
        } catch (IOException | InterruptedException problem) {
            return false;
        }
    }

    private void executable(String name, String script) throws IOException {
        Path file = folder.resolve(name);
        Files.createDirectories(file.getParent());
        Files.writeString(file, "#!/bin/sh\n" + script);
        assertTrue(file.toFile().setExecutable(true));
    }

    /** CodinGame's bot of the other tests, as a program of this name. */
    private void textBot(String name) throws IOException {
        Path pilot = Path.of("src/test/resources/codingame/pilot.py").toAbsolutePath();
        executable(name, "exec python3 " + CommandLine.quote(List.of(pilot.toString())) + "\n");
    }

    private static String fenced(String page, String fence, int number) throws IOException {
        Matcher blocks = Pattern.compile(fence, Pattern.DOTALL).matcher(Files.readString(Path.of(page)));
        for (int k = 0; k <= number; k++) {
            assertTrue(blocks.find(), page + ": block " + k);
        }
        return blocks.group(1);
    }

    /** The only line in a code block of the page that begins so. */
    private static String line(String page, String begin) throws IOException {
        List<String> lines = MarkdownPage.read(page).code().stream().map(MarkdownPage.Piece::text)
            .filter(text -> text.startsWith(begin)).toList();
        assertEquals(1, lines.size(), page + ": lines that begin with " + begin);
        return lines.get(0);
    }

    /** Runs a line of a page, which has to end with this status; what it wrote to either stream. */
    private String run(int status, String page, String begin) throws IOException, InterruptedException {
        return runLine(status, line(page, begin));
    }

    private String runLine(int status, String line) throws IOException, InterruptedException {
        ProcessBuilder shell = new ProcessBuilder("sh", "-c", line).directory(folder.toFile())
            .redirectErrorStream(true);
        shell.environment().merge("PATH", folder.resolve("bin").toString(), (path, bin) -> bin + ":" + path);
        Process process = shell.start();
        process.getOutputStream().close();
        String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertEquals(status, process.waitFor(), () -> line + "\n" + said);
        return said;
    }

    @Test
    void theReadmesBotPlaysAndItsReplayCanBeReadInEveryWay() throws IOException, InterruptedException {
        String said = run(0, "README.md", "steward match --bot 'me=python3 bot.py' --bot builtin:racer");
        assertEndsByTheRules(said);

        said = run(0, "README.md", "steward replay match.jsonl --verify");
        assertContains("verified: ", said);
        said = run(0, "README.md", "steward replay match.jsonl --turn 57");
        assertContains("57", said);
        said = run(0, "docs/replays.md", "steward replay match.jsonl --impacts");
        assertContains("impulse", said);
        said = run(0, "docs/replays.md", "steward replay match.jsonl --frames --player 0");
        assertTrue(said.startsWith("{\"type\":\"setup\","), said);
        run(0, "docs/watching.md", "steward replay match.jsonl --view match.html");
        assertTrue(Files.size(folder.resolve("match.html")) > 10_000);
        said = run(1, "docs/debugging.md", "steward feed match.jsonl --player racer -- builtin:veteran");
        assertContains("differs", said);
    }

    @Test
    void aBotOfTheSitePlaysAlsoAsCgBrutaltesterCallsIt() throws IOException, InterruptedException {
        textBot("a.out");
        String said = run(0, "docs/compatibility.md", "steward match --bot codingame:./a.out --bot builtin:racer");
        assertEndsByTheRules(said);

        textBot("mine");
        Files.copy(Path.of("src/test/resources/codingame/pilot.py"), folder.resolve("other.py"));
        run(0, "docs/compatibility.md", "steward referee -p1 ./mine");
        assertTrue(Files.exists(folder.resolve("game.json")));
        assertContains("verified: ", runLine(0, "steward replay match.jsonl --verify"));
    }

    @Test
    void theTestOfASimulatorHasTheAnswerThatIsShown() throws IOException, InterruptedException {
        Files.writeString(folder.resolve("tests.txt"), fenced("docs/compatibility.md", FENCE, 0));
        assertEquals(fenced("docs/compatibility.md", FENCE, 1),
            run(0, "docs/compatibility.md", "steward simulate < tests.txt"));
    }

    @Test
    void aSceneIsExplainedAndAnEnvironmentCanBeLeftBehind() throws IOException, InterruptedException {
        assertContains("3 bumpers", run(0, "docs/scenes.md", "steward explain walled-race"));

        // No interpreter here: where it is found through variables, as pyenv's may be, an empty environment hides it.
        executable("mine", "test -z \"$AN_OPINION$A_PASSWORD\" || exit 3\nexit 4\n");
        String hidden = line("docs/security.md", "env -i ");
        assertContains("exited with status 4", runLine(0, "AN_OPINION=own " + hidden));
        String open = hidden.substring(hidden.indexOf("steward match"));
        assertContains("exited with status 3", runLine(0, "AN_OPINION=own " + open));
        assertContains("exited with status 4", runLine(0, "A_PASSWORD=secret " + open));
    }

    /** Expects a race decided by the rules: the line names no seed, so on the map that is drawn either may win. */
    private static void assertEndsByTheRules(String said) {
        assertTrue(Pattern.compile("finished after 3 laps|is out: no checkpoint in 101 turns").matcher(said).find(),
            () -> "expected a race that ends by the rules, found:\n" + said);
    }

    private static void assertContains(String expected, String said) {
        assertTrue(said.contains(expected), () -> "expected " + expected + ", found:\n" + said);
    }

    @Test
    void aLineThatFailsIsFound() throws IOException {
        Files.writeString(folder.resolve("match.jsonl"), "no replay\n");
        assertThrows(AssertionError.class, () -> run(0, "README.md", "steward replay match.jsonl --verify"));
        assertThrows(AssertionError.class, () -> line("README.md", "steward nothing"));
    }
}
