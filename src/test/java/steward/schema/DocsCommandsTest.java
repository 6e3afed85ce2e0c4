package steward.schema;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

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
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.bot.command.CommandLine;

/**
 * Lines of README and manual, run by a shell as they stand there, in a folder with the bots that they name; and the
 * examples of {@code src/examples} that need nothing else. A line is found on its page by how it begins. Only time
 * limits are longer than shown: the machine may be busy. It takes long because each line starts the program.
 */
@Tag("process")
@Tag("slow")
@Timeout(300)
@Execution(ExecutionMode.CONCURRENT)
class DocsCommandsTest {

    private static final String FENCE = "```\\w*\\R(.*?)```";
    private static final Path PILOT = Path.of("src/test/resources/codingame/pilot.py").toAbsolutePath();
    /** End of a race by the rules: the lines name no seed, so on the map that is drawn either may win. */
    private static final Pattern RACE_END = Pattern.compile("finished after 3 laps|is out: no checkpoint in 101 turns");

    private static final String SCENES = "docs/scenes.md";
    private static final String AT_REST = " turns, all bodies are slower than the scene's restBelow";

    @TempDir
    private Path folder;
    private PageShell shell;

    @BeforeEach
    void prepare() throws IOException {
        shell = new PageShell(folder, """
            case "$1 $*" in
              *--time-factor*) ;;
              match*|referee*|play*) set -- "$@" --time-factor 100 ;;
            esac
            """);
    }

    /** Plays a race of a page, with the README's bot and CodinGame's bot of the other tests as programs. */
    private void race(String page, String begin) throws IOException, InterruptedException {
        PageShell.need("python3");
        Files.writeString(folder.resolve("bot.py"), PageShell.fenced("README.md", "```python\\R(.*?)```", 0));
        for (String name : List.of("a.out", "mine")) {
            shell.executable(name, "exec python3 " + CommandLine.quote(List.of(PILOT.toString())) + "\n");
        }
        String said = shell.run(0, page, begin);
        assertTrue(RACE_END.matcher(said).find(), () -> "expected a race that ends by the rules, found:\n" + said);
    }

    private void readmesRace() throws IOException, InterruptedException {
        race("README.md", "steward match --bot 'me=python3 bot.py' --bot builtin:racer");
    }

    @Test
    void theReadmesBotPlaysAndItsReplayVerifies() throws IOException, InterruptedException {
        readmesRace();
        shell.run(0, "README.md", "steward replay match.jsonl --verify", "verified: ");
    }

    @Test
    @Tag("campaign")
    void aReplayCanBeReadInEveryWay() throws IOException, InterruptedException {
        readmesRace();
        shell.run(0, "README.md", "steward replay match.jsonl --turn 57", "57");
        shell.run(0, "docs/replays.md", "steward replay match.jsonl --impacts", "impulse");
        String said = shell.run(0, "docs/replays.md", "steward replay match.jsonl --frames --player 0");
        assertTrue(said.startsWith("{\"type\":\"setup\","), said);
        shell.run(0, "docs/watching.md", "steward replay match.jsonl --view match.html");
        assertTrue(Files.size(folder.resolve("match.html")) > 10_000);
        shell.run(1, "docs/debugging.md", "steward feed match.jsonl --player racer -- builtin:veteran", "differs");
    }

    @Test
    @Tag("campaign")
    void aBotOfTheSitePlaysAlsoAsCgBrutaltesterCallsIt() throws IOException, InterruptedException {
        race("docs/protocol.md", "steward match --bot codingame:./a.out --bot builtin:racer");
        Files.copy(PILOT, folder.resolve("other.py"));
        shell.run(0, "docs/compatibility.md", "steward referee -p1 ./mine");
        assertTrue(Files.exists(folder.resolve("game.json")));
        shell.runLine(0, "steward replay match.jsonl --verify", "verified: ");
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
        shell.run(0, SCENES, "steward scene walled-race > my-scene.json");
        shell.run(0, SCENES, "steward explain my-scene.json", "\"scene\":\"walled-race\"");

        // No interpreter here: where it is found through variables, as pyenv's may be, an empty environment hides it.
        shell.executable("mine", "test -z \"$AN_OPINION$A_PASSWORD\" || exit 3\nexit 4\n");
        String hidden = PageShell.line("docs/security.md", "env -i ");
        String open = hidden.substring(hidden.indexOf("steward match"));
        shell.runLine(0, "AN_OPINION=own " + hidden, "exited with status 4");
        shell.runLine(0, "AN_OPINION=own " + open, "exited with status 3");
        shell.runLine(0, "A_PASSWORD=secret " + open, "exited with status 4");
    }

    private String example(String program, String name, String... expected) throws IOException, InterruptedException {
        return shell.runLine(0, program + " " + CommandLine.quote(List.of(Path.of("src/examples", name).toAbsolutePath()
            .toString())), expected);
    }

    /** Without air a ball that falls h = 100 u at g = 2 arrives at t = 10 and jumps to e^2 h = 64 u, at t = 18. */
    @Test
    void aDroppedBallJumpsToTheSquareOfItsRestitution() throws IOException, InterruptedException {
        String java = CommandLine.quote(List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString(),
            "-cp", System.getProperty("java.class.path")));
        double[] gaps = example(java, "library/DroppedBall.java").strip().lines()
            .mapToDouble(line -> Double.parseDouble(line.split(" ")[1])).toArray();
        assertEquals(100, gaps.length);
        assertArrayEquals(new double[] {0, 64, 0}, new double[] {gaps[9], gaps[17], gaps[99]}, 1e-9);
    }

    @Test
    void aSceneOfOnesOwnBecomesAMovingPicture() throws IOException, InterruptedException {
        example("sh", "shell/moving-picture.sh");
        String picture = Files.readString(folder.resolve("corner.svg"));
        assertTrue(picture.startsWith("<svg") && picture.split("<animate").length > 12, "12 discs move");
    }

    @Test
    @Tag("campaign")
    void fiveVersionsPlayALeague() throws IOException, InterruptedException {
        PageShell.need("python3");
        example("sh", "shell/league-of-five.sh", " thrust100 ", " thrust120 ", " thrust140 ", " thrust160 ",
            " thrust200 ", "20 games of mad-pod-racing");
    }

    /** Puts a scene of the page of scenes into the folder. */
    private void scene(String name) throws IOException {
        Files.writeString(folder.resolve(name + ".json"),
            PageShell.fenced(SCENES, "```json\\R(\\{ \"name\": \"" + name + "\".*?)```", 0));
    }

    private static void assertSays(String words) throws IOException {
        assertTrue(Files.readString(Path.of(SCENES)).replaceAll("\\s+", " ").contains(words), words);
    }

    /** From the middle of its first parabola, at a speed of 1, it falls n (n + 1) u in n turns: 690 u in turn 26. */
    @Test
    void aBallIsDroppedAndPlotted() throws IOException, InterruptedException {
        PageShell.need("python3");
        Files.copy(Path.of("docs/scenes/plot.py"), folder.resolve("plot.py"));
        scene("drop");
        shell.run(0, SCENES, "steward run drop.json", AT_REST);
        shell.run(0, SCENES, "steward replay drop.jsonl", "verified: ");
        assertTrue(Files.size(folder.resolve("drop.html")) > 10_000);
        assertEquals("26", Files.readAllLines(folder.resolve("drop/impacts.csv")).get(1).split(",")[0]);
        shell.run(0, SCENES, "python3 plot.py drop/states.csv y");
        String plot = Files.readString(folder.resolve("drop.svg"));
        assertTrue(plot.contains("y [u]: 100 to 7"), plot);
        assertEquals(Files.readAllLines(folder.resolve("drop/states.csv")).size() - 1,
            plot.split("points=\"")[1].split("\"")[0].split(" ").length);
    }

    @Test
    void aBreakHasPockets() throws IOException, InterruptedException {
        for (String file : List.of("break.json", "balls.csv")) {
            Files.copy(Path.of("docs/scenes", file), folder.resolve(file));
        }
        shell.runLine(0, "steward run break.json --out break.jsonl", AT_REST);
        assertSays("`steward run break.json` pots three");
        assertEquals(3, Files.readString(folder.resolve("break.jsonl")).split("\"kind\":\"death\"", -1).length - 1);
    }

    @Test
    void theDiscsOfABowlComeToRest() throws IOException, InterruptedException {
        scene("my-bowl");
        shell.runLine(0, "steward run my-bowl.json --seed 7", AT_REST);
        assertSays("It comes to rest, as `steward run my-bowl.json --seed 7` does");
    }

    @Test
    void aLineThatFailsIsFound() throws IOException {
        Files.writeString(folder.resolve("match.jsonl"), "no replay\n");
        assertThrows(AssertionError.class, () -> shell.run(0, "README.md", "steward replay match.jsonl --verify"));
        assertThrows(AssertionError.class, () -> shell.runLine(0, "steward --version", "no such words"));
        assertThrows(AssertionError.class, () -> PageShell.line("README.md", "steward nothing"));
    }
}
