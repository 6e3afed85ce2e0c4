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
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import steward.bot.command.ProgramFinder;
import steward.cli.Cli;
import steward.match.Protocol;
import steward.match.TestScenes;
import steward.replay.page.PageTestCase;
import steward.scene.SceneFiles;

/** The page of a match of the starter in Python against itself, in every game and protocol. */
@Tag("process")
@Tag("campaign")
class StarterPageTest extends PageTestCase {

    /** Each scene whose name is that of its game, and the first of the pod races, in both protocols. */
    static Stream<Arguments> protocolsAndScenes() {
        return SceneFiles.shipped().stream()
            .filter(scene -> scene.equals(gameOf(scene)) || scene.equals("mad-pod-racing"))
            .flatMap(scene -> Stream.of(Protocol.values()).map(spoken -> Arguments.of(spoken, scene)));
    }

    private static String gameOf(String scene) {
        return TestScenes.open(scene).scene().gameId();
    }

    @ParameterizedTest
    @MethodSource("protocolsAndScenes")
    void itsMatchIsShown(Protocol spoken, String scene) throws IOException {
        assumeTrue(ProgramFinder.find("python3") != null, "there is no python3");
        Path place = folder.resolve(spoken + "-" + scene);
        Cli made = Cli.run("new", "python", place.toString(), "--game", gameOf(scene), "--protocol", spoken.word());
        assertEquals(0, made.status(), made.err());
        Path page = place.resolve("page.html");
        String brief = TestScenes.text(scene).replaceFirst("\"maximumTurns\": \\d+", "\"maximumTurns\": 12");
        List<String> match = new ArrayList<>(List.of("match", "--scene",
            Files.writeString(place.resolve("brief.json"), brief).toString(), "--view", page.toString(),
            "--time-factor", "30"));
        for (int player = 0; player < TestScenes.open(scene).scene().players(); player++) {
            match.addAll(List.of("--bot", "p" + player + "=" + StarterLanguage.PYTHON.bot(spoken)
                .replace("bot.", place + "/bot.")));
        }
        Cli.run(match.toArray(String[]::new)).done();
        browser.open(page, "#t=3.5");
        assertTrue(browser.is("document.getElementById('notice').hidden"), browser.text("#notice"));
        assertTrue(browser.number("steward.bodies().length") > 0);
        browser.draw(0, browser.number("steward.lastTurn()"), 0.7);
    }
}
