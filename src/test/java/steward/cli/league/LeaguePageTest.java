package steward.cli.league;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import steward.cli.Cli;
import steward.cli.ShellBots;
import steward.cli.TextShellBots;
import steward.league.page.LeaguePage;
import steward.live.StatusServer;
import steward.replay.page.PageTestCase;

/** The page of a league in a real browser: from disk, and fed by a server; its replays are one click away. */
@Tag("process")
@Tag("slow")
@Timeout(300)
class LeaguePageTest extends PageTestCase {

    private static final int GAMES = 12;

    /** A league of which one bot plays. Its first number is that of the games; more fields may follow. */
    private static final String STATE = """
        {"scene":"duel","games":%1$d,"repeats":0,"again":0,"without":0,"rate":2.5,"bots":[{"rank":1,"version":1,\
        "name":"<i>a</i>","active":true,"random":false,"rating":12.5,"bar":30,"games":%1$d,"points":0.6,"faults":0,\
        "score":1,"meanMs":1,"worstMs":2}],"cross":[[null]],"path":{"versions":[1],"points":[]},%2$s}""";

    private static void done(String... words) {
        Cli.league(folder, words).done();
    }

    private interface Look {
        void at(StatusServer server) throws InterruptedException;
    }

    /** Opens the live page of a league in this state. */
    private static void live(String title, String state, Look look) throws IOException, InterruptedException {
        try (StatusServer server = StatusServer.start(null, 0, 200, LeaguePage.live(title, StatusServer.FEED),
                path -> null)) {
            server.show(state);
            browser.go(server.address().toString());
            look.at(server);
        }
    }

    private static int rows(String table) {
        return (int) browser.number("document.querySelectorAll('" + table + " tbody tr').length");
    }

    private static void assertNothingIsTooWide() {
        for (boolean dark : new boolean[] {false, true}) {
            browser.prefer(dark, false);
            for (int width : new int[] {390, 1280}) {
                browser.size(width, 800);
                assertTrue(browser.is("document.documentElement.scrollWidth <= innerWidth"), "wider than " + width);
            }
        }
    }

    @Test
    void everythingIsOnThePage() throws IOException {
        ShellBots.shortDuel(folder, 6);
        TextShellBots bots = new TextShellBots(folder);
        done("init", "TMP/a", "--scene", "TMP/short.json", "--seed", "5", "--keep", "all");
        done("add", "TMP/a", "drives=codingame:" + bots.driver());
        done("add", "TMP/a", "stays=codingame:" + bots.idler(0));
        done("add", "TMP/a", "fails=codingame:" + bots.idler(3));
        done("run", "TMP/a", "--games", Integer.toString(GAMES));
        done("page", "TMP/a", "--out", "TMP/page.html");
        browser.open(folder.resolve("page.html"), "");
        assertEquals(3, rows("#table"));
        assertEquals(3, rows("#cross"));
        assertEquals(GAMES, rows("#games"));
        assertTrue(browser.is("document.querySelectorAll('#path .chip').length === 3"));
        assertEquals(0, browser.number("document.querySelectorAll('#table .bars rect').length"),
            "no two of them took points from each other");
        assertTrue(browser.text("#meaning").contains(" took every point from "), browser.text("#meaning"));
        assertEquals(List.of(), browser.requests(), "nothing is asked of a network");

        browser.run("document.getElementById('result').value = 'failed';"
            + "document.getElementById('filter').dispatchEvent(new Event('change'))");
        assertEquals(8, rows("#games"), "fails fails in 8 of 12 games");
        browser.run("document.getElementById('result').value = '';"
            + "document.getElementById('kept').checked = true;"
            + "document.getElementById('filter').dispatchEvent(new Event('change'))");
        assertEquals(GAMES, rows("#games"));

        assertNothingIsTooWide();
        browser.click("#games a.link");
        browser.enterFrame();
        assertTrue(browser.text("h1").contains(" against "), browser.text("h1"));
        assertTrue(browser.is("[...document.querySelectorAll('#cards .fault')].some(fault => !fault.hidden)"),
            "a game in which a bot failed opens at that turn");
        assertTrue(browser.is("[...document.querySelectorAll('#cards .sent-box')].some(sent => !sent.hidden)"),
            "what was sent is there");
        browser.run("steward.seek(1)");
        browser.leaveFrame();
        browser.await("the address does not name game and moment", () ->
            browser.is("/^#game=\\d+&t=1\\.00$/.test(location.hash)"));
        String address = (String) browser.run("return location.hash");
        browser.run("history.back()");
        browser.await("Back does not close the game", () ->
            browser.is("!document.querySelector('iframe') && location.hash === ''"));
        browser.open(folder.resolve("page.html"), address);
        browser.enterFrame();
        browser.await("the game is not at the moment of its address", () -> browser.number("steward.time()") == 1);
        browser.leaveFrame();
        browser.open(folder.resolve("page.html"), "#game=999");
        assertEquals("Game 999 is not in this page: it is not among the games of this page",
            browser.text("#notice"));
    }

    @Test
    void anOpenPageFollows() throws IOException, InterruptedException {
        String state = STATE.formatted(1, "\"list\":[]");
        live("League", state, server -> {
            assertEquals("<i>a</i>", browser.text("#table tbody th.name"), "names are text");
            server.show(state.replace("\"games\":1", "\"games\":7"));
            browser.await("the page does not follow", () -> browser.text("#scene").contains("7 games of duel"));
            assertTrue(browser.is("document.body.classList.contains('live')"));
            server.end();
            browser.await("the page does not notice the end",
                () -> browser.is("!document.body.classList.contains('live')"));
        });
    }

    /** Ends elements, runs when an image fails, turns the direction of writing, rings. */
    private static final String HOSTILE = "</script><script>window.owned = 1</script>"
        + "<img src=x onerror='window.owned=1'><!--\u202Eevil\u0007";

    @Test
    void hostileTextsOfALivePageNeverRun() throws IOException, InterruptedException {
        String state = STATE.formatted(9, """
            "list":[{"id":1,"counts":false,"turns":3,"seed":"7","problem":"TEXT","replay":"TEXT",\
            "seats":[{"version":1,"rank":0,"fault":"TEXT"}]}],\
            "workers":[{"name":"TEXT","state":"TEXT","games":1,"aside":0,"rate":1,"faults":0,"repeated":0,\
            "program":"TEXT","silentMs":1,"doubts":["TEXT"]}]""").replace("<i>a</i>", "TEXT").replace("duel", "TEXT")
            .replace("TEXT", HOSTILE.replace("\u0007", "\\u0007"));
        live(HOSTILE, state, server -> {
            for (String shown : List.of("#table tbody th.name", "#games td.left", "#workers td.name", "#doubts li",
                "h1")) {
                assertTrue(browser.text(shown).contains("<img src=x"), shown + ": " + browser.text(shown));
            }
            assertTrue(browser.is("!window.owned && document.images.length === 0"));
        });
    }

    /** The bot writes the same to its standard error, and answers it. */
    @Test
    void whatAHostileBotWritesNeverRuns() throws IOException {
        Path bot = Files.writeString(folder.resolve("evil.sh"), "printf '%s\\n' \"" + HOSTILE + "\" >&2\nread -r line\n"
            + "printf '%s\\n' \"" + HOSTILE + "\"\n");
        TextShellBots bots = new TextShellBots(folder);
        done("init", "TMP/evil", "--scene", "duel", "--seed", "5", "--keep", "all", "--time-factor", "100");
        done("add", "TMP/evil", "drives=codingame:" + bots.driver());
        done("add", "TMP/evil", "evil=codingame:sh " + bot);
        done("run", "TMP/evil", "--games", "2");
        done("page", "TMP/evil", "--out", "TMP/evil.html");
        browser.open(folder.resolve("evil.html"), "");
        assertEquals(2, rows("#games"));
        assertTrue(browser.is("document.querySelector('#games .faulty').title.includes('script')"));
        assertTrue(browser.is("!window.owned && document.images.length === 0"));
        browser.click("#games a.link");
        browser.enterFrame();
        browser.run("steward.seek(steward.lastTurn())");
        assertTrue(browser.text("body").contains("<img src=x"), browser.text("body"));
        assertTrue(browser.is("!window.owned && document.images.length === 0"));
    }

    /** As {@link steward.league.page.WorkerRow} has them: one that plays, one that is caught, one that is doubtful. */
    @Test
    void workersAreShown() throws IOException, InterruptedException {
        String worker = """
            {"name":"%s","state":"%s","games":%d,"aside":%d,"rate":%s,"faults":%d,"repeated":%d,"program":"0.1.0",\
            "silentMs":%d,"doubts":[%s]}""";
        live("League", STATE.formatted(9, "\"list\":[],\"workers\":["
            + worker.formatted("attic", "4 at a time", 12_345, 0, "3.25", 0, 2, 1999, "") + ","
            + worker.formatted("<i>cellar</i>", "caught", 0, 17, "0", 3, 0, 61_000, "") + ","
            + worker.formatted("a-rather-long-name-of-a-worker", "away", 40, 0, "0.5", 1, 0, -1,
                "\"fast fails in 9 of its 40 games and in 2 of 300 others of the same lineup, by chance 0.0001%\"")
            + "]"), server -> {
                assertEquals(3, rows("#workers"));
                assertEquals("attic", browser.text("#workers tbody tr:nth-child(1) td.name"));
                assertEquals("<i>cellar</i>", browser.text("#workers tbody tr:nth-child(2) td.name"), "names are text");
                assertEquals("caught", browser.text("#workers tbody tr:nth-child(2) td.faulty"));
                assertEquals("attic 4 at a time 12 345 3.25 0 2 0 0.1.0 2 s ago",
                    browser.text("#workers tbody tr:nth-child(1)").replaceAll("[\\s\u00a0\u2009\u202f]+", " "));
                assertTrue(browser.text("#doubts li").startsWith("a-rather-long-name-of-a-worker is doubtful: fast "
                    + "fails in 9 of its 40 games"), browser.text("#doubts li"));
                assertNothingIsTooWide();
            });
    }
}
