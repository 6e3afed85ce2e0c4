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
import steward.bots.pokerchiprace.Glutton;
import steward.bots.pokerchiprace.Nibbler;
import steward.match.TestScenes;
import steward.replay.Recorded;

/** The look of the Poker Chip Race in a real browser: every turn is drawn without a complaint, with areas and chips. */
@Tag("browser")
@Execution(ExecutionMode.CONCURRENT)
@ResourceLock(PageTestBrowser.LOCK)
class PokerChipRacePageTest {

    @TempDir
    static Path folder;

    @Test
    void aWholeGameIsDrawn() {
        Recorded match = Recorded.of(TestScenes.open("poker-chip-race"), 7,
            List.of(BundledBots.of(new Glutton()), BundledBots.of(new Nibbler())));
        Path page = new PageTestPages(folder).page(match.bytes(), "Poker Chip Race");
        try (PageTestBrowser browser = PageTestBrowser.start()) {
            browser.size(1280, 720);
            browser.prefer(true, false);
            browser.open(page, "");
            browser.run("steward.pause()");
            browser.draw(0, match.result().turns(), 2.5);
            browser.run("steward.seek(0)");
            assertTrue(browser.text("#scores .big").matches("[0-9\u2009]+ u²"), browser.text("#scores .big"));
            assertTrue(browser.text("#scores .small").matches("[1-5] chips?( · .*)?"), browser.text("#scores .small"));
            browser.run("steward.seek(steward.lastTurn())");
            assertEquals(List.of(), browser.complaints());
        }
    }
}
