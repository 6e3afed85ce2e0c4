package steward.cli.tournament;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.zip.GZIPInputStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.api.parallel.ResourceLock;
import picocli.CommandLine;
import steward.cli.options.WatchOptions;
import steward.cli.streams.Streams;
import steward.league.Season;
import steward.league.StoredGame.StoredSeat;
import steward.league.StoredGame;
import steward.league.rating.LeagueTable;
import steward.replay.page.PageTestBrowser;
import steward.replay.page.PageTestRaces;

/**
 * Pages of a tournament with replays: the wall of a class, and an author's. It takes long because the wall plays a game
 * to its end at the pace at which people watch it.
 */
@Tag("slow")
@Timeout(300)
@Execution(ExecutionMode.CONCURRENT)
class TournamentPagesTest {

    private static final int VIEWERS = 40;
    private static final String SECRET = "secret of right";

    @TempDir
    private Path folder;

    private final ByteArrayOutputStream err = new ByteArrayOutputStream();
    private ProjectorWall wall;
    private String address;

    @BeforeEach
    void begin() throws Exception {
        String scene = PageTestRaces.scene("duel").replace("\"maximumTurns\": 200", "\"maximumTurns\": 20");
        String replay = new String(PageTestRaces.play(scene, 3), StandardCharsets.UTF_8);
        Files.writeString(folder.resolve("a.jsonl"), replay.replaceAll("(,\"stderr\":\\[.*?\\])?,\"turnHash\"",
            ",\"stderr\":[\"my own\",\"" + SECRET + "\"],\"turnHash\""));
        wall = ProjectorWall.start(CommandLine.populateCommand(new WatchOptions(), "--watch"),
            new Streams(new ByteArrayOutputStream(), err, false, false));
        address = err.toString(StandardCharsets.UTF_8).replaceAll("(?s).*(http://\\S+).*", "$1");
        wall.follow(played(), folder, Scores::of);
    }

    @AfterEach
    void end() {
        if (wall != null) {
            wall.close();
        }
    }

    private static PlayedGames played() {
        return new PlayedGames(Season.of("s", "k", "l", "r", 2, false), List.of(
            new LeagueTable.Entry(1, "left", false, true), new LeagueTable.Entry(2, "right", false, true)), List.of());
    }

    private static StoredGame game(int id, String fault) {
        return new StoredGame(id, new byte[16], id, 7, 1, true, 12, null, 0, "m", "a.jsonl", 0, List.of(
            new StoredSeat(1, 1, 0, fault, 5, 0, 0, 0), new StoredSeat(2, 0, 1, null, 12, 0, 0, 0)));
    }

    @Test
    @Tag("process")
    @Tag("browser")
    @ResourceLock(PageTestBrowser.LOCK)
    void theWallShowsTheTableAndAGameWithoutPanelsAndBeginsNoneAfterTheEnd() {
        try (PageTestBrowser browser = PageTestBrowser.start()) {
            browser.go(address);
            wall.add(game(1, null));
            wall.say("Round 1: left - right");
            browser.await("no game is played", () -> browser.is("steward.playing && document.querySelector('iframe')"
                + ".contentWindow.steward.time() > 0.5"));
            assertEquals("left against right", browser.text("#title"));
            assertEquals("Round 1: left - right", browser.text("#says"));
            assertEquals("1\tright\t1\t1\t1\t0\t0\n2\tleft\t0\t1\t0\t0\t1", browser.text("#rows"));
            for (String panel : List.of("aside", ".transport")) {
                assertTrue(browser.is("document.querySelector('iframe').contentDocument.querySelector('" + panel
                    + "').offsetHeight === 0"), panel);
            }
            for (String key : List.of("f", "F")) {
                assertTrue(browser.is("(document.documentElement.requestFullscreen = () => { steward.full = '" + key
                    + "'; }, dispatchEvent(new KeyboardEvent('keydown', { key: '" + key + "' })), steward.full === '"
                    + key + "')"), key);
            }
            wall.end(played().with(game(1, null)).with(game(2, null)));
            browser.await("the end is not told", () -> browser.text("#says").equals("The tournament is over."));
            browser.await("the game does not end", () -> browser.is("!steward.playing"));
            assertTrue(browser.is("steward.shown === 1"), "no game more is begun");
            assertEquals(List.of(), browser.complaints());
        }
    }

    /** What 40 browsers are sent at the end, and no word of what a bot wrote to stderr. */
    @Test
    void fortyViewersSeeTheEnd() throws Exception {
        HttpClient client = HttpClient.newHttpClient();
        List<CompletableFuture<HttpResponse<String>>> feeds = new ArrayList<>();
        for (int k = 0; k < VIEWERS; k++) {
            feeds.add(client.sendAsync(HttpRequest.newBuilder(URI.create(address + "feed")).build(),
                HttpResponse.BodyHandlers.ofString()));
        }
        wall.add(game(1, null));
        wall.say("now");
        HttpResponse<String> replay = client.send(HttpRequest.newBuilder(URI.create(address + "replay/1")).build(),
            HttpResponse.BodyHandlers.ofString());
        assertEquals(200, replay.statusCode());
        byte[] lines = new GZIPInputStream(new ByteArrayInputStream(
            Base64.getDecoder().decode(replay.body().split("\n")[0]))).readAllBytes();
        assertFalse(new String(lines, StandardCharsets.UTF_8).contains(SECRET));
        wall.end(played().with(game(1, null)));
        wall.close();
        wall = null;
        for (CompletableFuture<HttpResponse<String>> feed : feeds) {
            assertTrue(feed.get().body().contains("\"over\":true") && feed.get().body().contains("right"));
        }
    }

    @Test
    @Tag("process")
    @Tag("browser")
    @ResourceLock(PageTestBrowser.LOCK)
    void anAuthorSeesTheFailureWithTheOwnStderrAndNobodyElses() throws Exception {
        PlayedGames played = played().with(game(1, null)).with(game(2, "exited with status 1"));
        Path page = folder.resolve("left.html");
        new AuthorPage(new TournamentCommand.Entry(new Workshop.Ready(new Programs.Program("left", page,
            Programs.Kind.PYTHON), null, null, List.of(), "none", null), null), 1, played.games(), played.names(),
            folder).write(page);
        try (PageTestBrowser browser = PageTestBrowser.start()) {
            browser.openPlain(page);
            assertTrue(browser.text("table.games").contains("failed in turn 5: exited with status 1"));
            assertTrue(browser.is("document.querySelector('[data-game=\"2\"]').hash === '#game=2&fault=0'"));
            browser.click("[data-game=\"1\"]");
            browser.enterFrame();
            browser.await("it does not stand at the end", () ->
                browser.is("steward.turn() === Math.min(12, steward.lastTurn())"));
            assertTrue(browser.text("#cards").contains("my own"), browser.text("#cards"));
            assertFalse(browser.text("body").contains(SECRET));
            assertEquals(List.of(), browser.complaints());
        }
    }
}
