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
import steward.bots.fantasticbits.Captain;
import steward.bots.fantasticbits.Chaser;
import steward.match.TestScenes;
import steward.replay.Recorded;

/** The look of Fantastic Bits in a real browser: every turn is drawn without a complaint, goals and magic are told. */
@Tag("browser")
@Execution(ExecutionMode.CONCURRENT)
@ResourceLock(PageTestBrowser.LOCK)
class FantasticBitsPageTest {

    @TempDir
    static Path folder;

    @Test
    void aWholeMatchIsDrawn() {
        Recorded match = Recorded.of(TestScenes.open("fantastic-bits"), 7,
            List.of(BundledBots.of(new Captain()), BundledBots.of(new Chaser())));
        assertTrue(match.text().contains("\"spell\":\"flipendo\""), "spells are drawn too");
        Path page = new PageTestPages(folder).page(match.bytes(), "Fantastic Bits");
        try (PageTestBrowser browser = PageTestBrowser.start()) {
            browser.size(1280, 720);
            browser.prefer(true, false);
            browser.open(page, "");
            browser.run("steward.pause()");
            browser.draw(0.5, match.result().turns(), 1);
            browser.run("steward.seek(0)");
            assertEquals("0 goals", browser.text("#scores .big"));
            assertEquals("0 magic", browser.text("#scores .small"));
            browser.run("steward.seek(steward.lastTurn())");
            int goals = (int) match.result().players().get(0).score();
            assertTrue(browser.text("#scores .big").startsWith(goals + " goal"), browser.text("#scores .big"));
            assertEquals(List.of(), browser.complaints());
        }
    }
}
