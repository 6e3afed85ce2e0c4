package steward.cli.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import steward.cli.Cli;
import steward.cli.ShellBots;
import steward.cli.TextShellBots;
import steward.replay.page.PageTestCase;

/** The page of a series in a real browser: won, drawn and failed games, with and without kept replays. */
@Tag("process")
@Tag("slow")
@Timeout(300)
class SeriesPageTest extends PageTestCase {

    private TextShellBots bots;

    @BeforeEach
    void scene() throws IOException {
        assumeTrue(ShellBots.runnable(), "skipped: there is no /bin/sh");
        Files.writeString(folder.resolve("short.json"), Files.readString(Path.of("config/scenes/duel.json"))
            .replace("\"maximumTurns\": 200", "\"maximumTurns\": 6").replace("\"answerMs\": 75", "\"answerMs\": 30000")
            .replace("\"firstAnswerMs\": 1000", "\"firstAnswerMs\": 60000"));
        bots = new TextShellBots(folder);
    }

    private Path played(String other, String... more) {
        Cli cli = Cli.run(List.of("match", "--scene", folder + "/short.json", "--bot",
            "drives=codingame:" + bots.driver(), "--bot", other, "--games", "3", "--swap", "--seed", "5", "--view",
            folder + "/series.html", "--overwrite"), more).done();
        assertTrue(cli.out().contains("Page: " + folder + "/series.html"), cli.out());
        return folder.resolve("series.html");
    }

    @Test
    void aBotThatFailsIsNamedWithItsTurnAndItsGameIsOneClickAway() throws IOException {
        Path page = played("fails=codingame:" + bots.idler(3), "--out", folder + "/games");
        browser.open(page, "");
        assertEquals("6 games of duel, 3 seeds, sides changed", browser.text("#scene"));
        assertEquals(3, browser.number("document.querySelectorAll('#games tbody tr').length"));
        assertEquals(6, browser.number("document.querySelectorAll('#games a.won').length"));
        assertTrue(browser.text("#failures").startsWith("fails, 6 games: "), browser.text("#failures"));
        assertEquals(List.of("drives as player 0\t3\t3\t0\t0", "drives as player 1\t3\t3\t0\t0"),
            browser.text("#sides tbody").lines().toList());
        browser.run("document.getElementById('which').value = 'lost';"
            + "document.getElementById('which').dispatchEvent(new Event('change'))");
        assertEquals("0 of 6", browser.text("#count"));
        for (int width : new int[] {390, 1280}) {
            browser.size(width, 800);
            assertTrue(browser.is("document.documentElement.scrollWidth <= innerWidth"), "wider than " + width);
        }
        browser.open(page, "#game=2&t=2");
        browser.enterFrame();
        browser.await("it is not at its moment", () -> browser.number("steward.time()") == 2);
        assertEquals("fails against drives", browser.text("h1"));
        browser.run("steward.go('#fault')");
        double failed = browser.number("steward.match().faults[0].time");
        assertTrue(failed > 2, "the fault is later");
        browser.leaveFrame();
        browser.await("the address does not follow", () ->
            browser.is("location.hash === '#game=2&t=" + (int) failed + ".00'"));
        browser.click("section header button");
        assertTrue(browser.is("location.hash === '' && !document.querySelector('iframe')"));
        assertEquals(List.of(), browser.requests(), "nothing is asked of a network");
    }

    @Test
    void withoutAReplayThePageNamesTheOptionThatKeepsIt() throws IOException {
        String idle = "stays=codingame:" + bots.idler(0);
        String driver = "same=codingame:" + bots.driver();
        browser.open(played(driver), "#game=1");
        assertEquals("No replay is in this page: --out DIR keeps the replays of all games, and this page has them "
            + "then.", browser.text("#kept"));
        assertTrue(browser.text("#notice").startsWith("Game 1 is not in this page: --out DIR"));
        assertFalse(browser.is("document.querySelector('#games a')"));
        browser.open(played(idle, "--out", folder + "/some", "--keep", "failed"), "");
        assertTrue(browser.text("#kept").contains("--keep failed did not keep its replay; --keep all keeps all"),
            browser.text("#kept"));
    }
}
