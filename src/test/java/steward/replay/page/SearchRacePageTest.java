package steward.replay.page;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.api.parallel.ResourceLock;
import steward.bots.BundledBots;
import steward.bots.searchrace.Driver;
import steward.match.TestScenes;
import steward.replay.Recorded;
import steward.text.TextFormat;

/** The look of the search race in a real browser: every turn is drawn without a complaint, the result is the time. */
@Tag("browser")
@Execution(ExecutionMode.CONCURRENT)
@ResourceLock(PageTestBrowser.LOCK)
class SearchRacePageTest {

    @TempDir
    static Path folder;

    @Test
    void aWholeRaceIsDrawn() {
        Recorded race = Recorded.of(TestScenes.open("search-race"), 7, List.of(BundledBots.of(new Driver())));
        Path page = new PageTestPages(folder).page(race.bytes(), "Search race");
        try (PageTestBrowser browser = PageTestBrowser.start()) {
            browser.size(1280, 720);
            browser.prefer(true, false);
            browser.open(page, "");
            browser.run("steward.pause()");
            browser.draw(0, race.result().turns(), 20);
            browser.run("steward.seek(0)");
            assertEquals("Lap 1/3", browser.text("#scores .big"));
            assertTrue(browser.text("#scores .small").startsWith("0 of "), browser.text("#scores .small"));
            browser.run("steward.seek(steward.lastTurn())");
            assertEquals(TextFormat.fixed(race.result().players().get(0).score(), 2) + " turns",
                browser.text("#scores .big"));
            assertEquals(List.of(), browser.complaints());
        }
    }
}
