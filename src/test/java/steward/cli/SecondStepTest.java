package steward.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.URISyntaxException;
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
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.api.parallel.ResourceLock;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import steward.cli.shared.Games;
import steward.codingame.recording.SiteGames;
import steward.replay.page.PageTestBrowser;
import steward.scene.Scene;
import steward.scene.SceneFiles;

/**
 * What somebody does second, after a scene is found: it is explained, played by its name with the bots that come with
 * it, verified and shown; a game of the site is imported, verified and shown; every page opens. That a page shows every
 * body is {@code EveryScenePageTest}'s. That every starter plays, and is shown, is {@code NewCommandTest}'s and {@code
 * StarterPageTest}'s. It takes long because each shipped scene is played by processes, and each page by a browser.
 */
@Execution(ExecutionMode.CONCURRENT)
class SecondStepTest {

    /** Folders of the pages that the program writes; that of the toolkit's viewer needs a player of CodinGame. */
    private static final Set<String> PAGES = Set.of("view", "series", "league", "beside");
    private static final String OF_THE_TOOLKIT = "viewer";

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

    static Stream<String> gamesOfTheSite() {
        return Games.ids().stream().filter(game -> Games.types().viewWriter(game).isPresent());
    }

    /** A game whose views are known here and of which no recorded game is known fails. */
    @ParameterizedTest
    @MethodSource("gamesOfTheSite")
    @Tag("slow")
    void aGameOfTheSiteIsImportedVerifiedAndShown(String game) throws IOException {
        Path recorded = Files.writeString(folder.resolve("game.json"), SiteGames.of(game));
        String replay = folder.resolve("imported.jsonl").toString();
        assertTrue(Cli.run("import", recorded.toString(), "--out", replay).done().out().startsWith("imported: "), game);
        String verified = Cli.run("replay", replay, "--verify").out();
        assertTrue(verified.matches("(?s)verified(: | up to the cut: ).* numbers and words equal\n.*"), verified);
        Path page = folder.resolve("imported.html");
        Cli.run("replay", replay, "--view", page.toString()).done();
        assertTrue(Files.readString(page).contains("<canvas"), game);
    }

    @Test
    void everyGameHasAShippedScene() {
        assertEquals(Set.copyOf(Games.ids()), scenes().map(name -> Games.open(name).scene().gameId())
            .collect(Collectors.toSet()));
    }

    /** A page without an address here fails; each is opened from the disk, as a second step has written it. */
    @Test
    @Tag("browser")
    @Tag("slow")
    @ResourceLock(PageTestBrowser.LOCK)
    void everyPageOpensWithoutComplaint() throws IOException, URISyntaxException {
        Path view = Path.of(getClass().getResource("/steward/view/page.html").toURI());
        try (Stream<Path> files = Files.walk(view.getParent().getParent())) {
            assertEquals(Stream.concat(PAGES.stream(), Stream.of(OF_THE_TOOLKIT)).collect(Collectors.toSet()),
                files.filter(file -> file.endsWith("page.html")).map(file -> file.getParent().getFileName().toString())
                    .collect(Collectors.toSet()));
        }
        ShellBots.shortDuel(folder, 6);
        List<String> duel = List.of("match", "--scene", folder + "/short.json", "--bot", "a=builtin:racer", "--bot",
            "b=builtin:veteran", "--no-deadline", "--seed");
        Cli.run(duel, "1", "--out", folder + "/match.jsonl", "--view", folder + "/view.html").done();
        Cli.run(duel, "1", "--out", folder + "/again.jsonl").done();
        Cli.run("replay", folder + "/match.jsonl", "--beside", folder + "/again.jsonl", "--view",
            folder + "/beside.html").done();
        Cli.run(duel, "2", "--games", "4", "--view", folder + "/series.html").done();
        String league = folder + "/league";
        Cli.run("league", "init", league, "--scene", folder + "/short.json", "--keep", "all").done();
        Cli.run("league", "add", league, "a=builtin:racer").done();
        Cli.run("league", "add", league, "b=builtin:veteran").done();
        Cli.run("league", "run", league, "--games", "4").done();
        Cli.run("league", "page", league, "--out", folder + "/league.html").done();
        try (PageTestBrowser browser = PageTestBrowser.start()) {
            for (String page : PAGES) {
                browser.open(folder.resolve(page + ".html"), "");
                assertEquals(List.of(), browser.complaints(), page);
                assertEquals(List.of(), browser.requests(), page + " asks a network for nothing");
                assertTrue(browser.number("document.body.innerText.trim().length") > 0, page);
            }
        }
    }
}
