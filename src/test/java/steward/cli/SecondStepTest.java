package steward.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import steward.cli.shared.Games;
import steward.scene.Scene;
import steward.scene.SceneFiles;

/**
 * What somebody does second, after a scene is found: it is explained, played by its name with the bots that come with
 * it, verified and shown. That the page shows every body is {@code EveryScenePageTest}'s, that starters of each game
 * play is {@code NewCommandTest}'s.
 */
class SecondStepTest {

    @TempDir
    private Path folder;

    static Stream<String> scenes() {
        return SceneFiles.shipped().stream();
    }

    @ParameterizedTest
    @MethodSource("scenes")
    @Tag("process")
    @Tag("slow")
    void aShippedSceneIsExplainedPlayedVerifiedAndShown(String name) throws IOException {
        Scene scene = Games.open(name).scene();
        String replay = folder.resolve("match.jsonl").toString();
        Path page = folder.resolve("match.html");
        assertTrue(Cli.run("explain", name).done().out().contains(name), name);
        List<String> call = new ArrayList<>(scene.players() == 0 ? List.of("run", name, "--turns", "12")
            : List.of("match", "--scene", name, "--seed", "1", "--no-deadline"));
        for (int player = 0; player < scene.players(); player++) {
            String bot = Games.weakestBot(scene.gameId());
            assertNotNull(bot, scene.gameId() + " has no bot");
            call.addAll(List.of("--bot", "p" + player + "=builtin:" + bot));
        }
        Cli.run(call, "--out", replay).done();
        String verified = Cli.run("replay", replay, "--verify").done().out();
        assertTrue(verified.startsWith("verified: "), verified);
        Cli.run("replay", replay, "--view", page.toString()).done();
        assertTrue(Files.readString(page).contains("<canvas"), name);
    }

    @Test
    void everyGameHasAShippedScene() {
        assertEquals(Set.copyOf(Games.ids()), scenes().map(name -> Games.open(name).scene().gameId())
            .collect(Collectors.toSet()));
    }
}
