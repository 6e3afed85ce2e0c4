package steward.schema;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.tools.JavaCompiler;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import steward.bot.InProcessPlayer;
import steward.bot.process.BotProcess;
import steward.bots.BundledBotMatches;
import steward.bots.Racer;
import steward.game.Game;
import steward.game.GameJson;
import steward.game.GameSetup;
import steward.game.podrace.PodRace;
import steward.game.podrace.PodState;
import steward.match.MatchListener;
import steward.match.MatchResult;
import steward.match.Referee;
import steward.match.TeeListener;
import steward.match.TestScenes;
import steward.match.TimeControl;
import steward.match.Turn;
import steward.replay.ReplayHeader;
import steward.replay.ReplayWriter;

/** Claims of README and manual are true: the frames are frames, the scene is a scene, the bot plays. */
class ReadmeTest {

    private static final String PROTOCOL = "docs/protocol.md";

    private static String block(String page, String language, int number) throws IOException {
        return PageShell.fenced(page, "```" + language + "\\R(.*?)```", number);
    }

    /** Compiles a source into a folder. */
    private static void compile(Path folder, String name, String text) throws IOException {
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        assumeTrue(compiler != null, "skipped: this Java has no compiler");
        ByteArrayOutputStream said = new ByteArrayOutputStream();
        assertEquals(0, compiler.run(null, said, said, "-cp", System.getProperty("java.class.path"), "-proc:none", "-d",
            folder.toString(), Files.writeString(folder.resolve(name), text).toString()), said::toString);
    }

    @Test
    void theFramesAreValid() throws IOException {
        String[] lines = block(PROTOCOL, "json", 0).strip().split("\\R");
        List<String> names = List.of("setup", "turn", "end");
        assertEquals(names.size(), lines.length);
        for (int k = 0; k < lines.length; k++) {
            assertEquals(List.of(), Schemas.problems(Schemas.open(names.get(k)), lines[k]), names.get(k));
        }
        assertEquals(List.of(), Schemas.problems(Schemas.open("answer"), block(PROTOCOL, "json", 1).strip()));
    }

    @Test
    void theSceneCanBePlayed() throws IOException {
        GameSetup setup = TestScenes.TYPES.open(block("docs/scenes.md", "json", 0), "scenes.md");
        assertEquals("walled-race", setup.scene().name());
        assertEquals(List.of(), setup.check());
    }

    @Test
    @Tag("process")
    void theBotWinsTheMatchThatIsShown(@TempDir Path folder) throws Exception {
        PageShell.need("python3");
        Path bot = Files.writeString(folder.resolve("bot.py"), block("README.md", "python", 0));
        MatchResult result = new Referee(TestScenes.open("mad-pod-racing"), 7,
            List.of(new BotProcess("me", List.of("python3", bot.toString())),
                new InProcessPlayer("racer", BundledBotMatches.asBot(new Racer()))),
            TimeControl.UNLIMITED, new MatchListener() { }).play();

        assertNull(result.players().get(0).fault());
        assertEquals(0, result.winner());
        String shown = block(PROTOCOL, "json", 0).strip().split("\\R")[2];
        assertTrue(shown.contains("\"turns\":" + result.turns() + ","), PROTOCOL + " says " + shown);
    }

    /** The README's match in Java compiles, with the imports of the library's page. */
    @Test
    @Tag("slow")
    void theMatchInJavaCompiles(@TempDir Path folder) throws IOException {
        String page = block("docs/library.md", "java", 1);
        compile(folder, "Readme.java", page.substring(0, page.indexOf("public class"))
            + "class Readme {\n    void play() throws Exception {\n" + block("README.md", "java", 0) + "    }\n}\n");
    }

    /** The library's page reads the places of all pods of a race as the race itself has them. */
    @Test
    @Tag("slow")
    void theStatesOfAReplayAreRecords(@TempDir Path folder) throws Exception {
        Path race = folder.resolve("race.jsonl");
        List<String> played = new ArrayList<>();
        try (ReplayWriter writer = new ReplayWriter(Files.newOutputStream(race), new ReplayHeader("pod-race",
                TestScenes.open("mad-pod-racing").scene().json(), 7, List.of("one", "two"), List.of("1", "2"), 1))) {
            new Referee(TestScenes.open("mad-pod-racing"), 7,
                List.of(new InProcessPlayer("one", BundledBotMatches.asBot(new Racer())),
                    new InProcessPlayer("two", BundledBotMatches.asBot(new Racer()))), TimeControl.UNLIMITED,
                new TeeListener(writer, new MatchListener() {
                    private PodRace game;

                    @Override
                    public void start(Game started, GameJson json) {
                        game = (PodRace) started;
                    }

                    @Override
                    public void played(Turn turn) {
                        for (int pod = 0; pod < 4; pod++) {
                            PodState now = game.pod(pod);
                            played.add(turn.number() + " " + pod + " " + now.x() + " " + now.y() + " " + now.passed());
                        }
                    }
                })).play();
        }
        compile(folder, "ReplayStates.java", block("docs/library.md", "java", 2)
            .replace("void main(String[] files)", "void read(java.util.List<String> lines, String... files)")
            .replace("System.out.println(", "lines.add("));
        List<String> read = new ArrayList<>();
        try (URLClassLoader loader = new URLClassLoader(new URL[] {folder.toUri().toURL()})) {
            loader.loadClass("ReplayStates").getMethod("read", List.class, String[].class)
                .invoke(null, read, new String[] {race.toString()});
        }

        assertTrue(read.size() > 400, read.size() + " lines");
        assertEquals(played, read);
    }
}
