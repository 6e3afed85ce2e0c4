package steward.cli.setup;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.api.parallel.ResourceLock;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import steward.bot.command.CommandLine;
import steward.bot.command.ProgramFinder;
import steward.cli.Cli;
import steward.match.TestScenes;
import steward.replay.page.PageTestBrowser;
import steward.scene.SceneFiles;

/** The page of a match of every starter against itself, in every game that has one. */
@Tag("browser")
@Tag("process")
@Tag("campaign")
@Execution(ExecutionMode.CONCURRENT)
@ResourceLock(PageTestBrowser.LOCK)
class StarterPageTest {

    @TempDir
    private Path folder;

    /** Each scene whose name is that of its game, and the first of the pod races. */
    static Stream<Arguments> startersAndScenes() {
        return SceneFiles.shipped().stream()
            .filter(scene -> scene.equals(gameOf(scene)) || scene.equals("mad-pod-racing"))
            .flatMap(scene -> Stream.of(Starter.values()).filter(starter -> starter.isFor(gameOf(scene)))
                .map(starter -> Arguments.of(starter, scene)));
    }

    private static String gameOf(String scene) {
        return TestScenes.open(scene).scene().gameId();
    }

    @ParameterizedTest
    @MethodSource("startersAndScenes")
    void itsMatchIsShown(Starter starter, String scene) throws IOException, InterruptedException {
        Path place = folder.resolve("bot");
        List<String> call = new ArrayList<>(List.of("new", starter.word(), place.toString(), "--game", gameOf(scene)));
        call.addAll(starter.searches() ? List.of("--simulator") : List.of("--protocol", starter.protocol().word()));
        Cli made = Cli.run(call.toArray(String[]::new));
        assertEquals(0, made.status(), made.err());
        for (String command : starter.compile()) {
            List<String> words = CommandLine.split(command);
            assumeTrue(ProgramFinder.find(words.get(0)) != null, "there is no " + words.get(0));
            assertEquals(0, new ProcessBuilder(words).directory(place.toFile()).inheritIO().start().waitFor());
        }
        Path page = folder.resolve("page.html");
        String brief = TestScenes.text(scene).replaceFirst("\"maximumTurns\": \\d+", "\"maximumTurns\": 12");
        List<String> match = new ArrayList<>(List.of("match", "--scene",
            Files.writeString(folder.resolve("brief.json"), brief).toString(), "--view", page.toString(),
            "--time-factor", "30"));
        for (int player = 0; player < TestScenes.open(scene).scene().players(); player++) {
            match.addAll(List.of("--bot", "p" + player + "=" + starter.bot().replace("./bot", place + "/bot")
                .replace("bot.", place + "/bot.").replace("java Bot", "java -cp " + place + " Bot")));
        }
        Cli played = Cli.run(match.toArray(String[]::new));
        assertEquals(0, played.status(), played.err());
        try (PageTestBrowser browser = PageTestBrowser.start()) {
            browser.open(page, "#t=3.5");
            assertTrue(browser.is("document.getElementById('notice').hidden"), browser.text("#notice"));
            assertTrue(browser.number("steward.bodies().length") > 0);
            browser.draw(0, browser.number("steward.lastTurn()"), 0.7);
            assertEquals(List.of(), browser.complaints());
        }
    }
}
