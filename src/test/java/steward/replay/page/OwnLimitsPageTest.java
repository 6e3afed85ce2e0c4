package steward.replay.page;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.api.parallel.ResourceLock;

/** The page of a match in a real browser in which one bot has limits of its own. */
@Tag("browser")
@Execution(ExecutionMode.CONCURRENT)
@ResourceLock(PageTestBrowser.LOCK)
class OwnLimitsPageTest {

    @TempDir
    static Path folder;

    @Test
    void eachAnswerTimeStandsBesideTheLimitOfItsPlayer() {
        String replay = new String(PageTestRaces.play(PageTestRaces.scene("duel"), 5), StandardCharsets.UTF_8)
            .replaceFirst("\"protocol\":\"json\"}]", "\"protocol\":\"json\",\"time\":{\"firstAnswerMs\":500,"
                + "\"answerMs\":60}}]");
        Path page = new PageTestPages(folder).page(replay.getBytes(StandardCharsets.UTF_8), "Duel");
        try (PageTestBrowser browser = PageTestBrowser.start()) {
            browser.open(page, "#turn=1");
            assertLimits(browser, 1, 1000, 500);
            browser.run("steward.seek(2)");
            assertLimits(browser, 2, 75, 60);
            assertEquals(List.of(), browser.complaints());
        }
    }

    private static void assertLimits(PageTestBrowser browser, int turn, int... limits) {
        browser.await("turn " + turn + " is not shown", () -> browser.text("#turn-shown").equals("Turn " + turn));
        for (int player = 0; player < limits.length; player++) {
            String card = browser.text("#cards .card:nth-child(" + (player + 1) + ")");
            assertTrue(card.contains(" ms of " + limits[player]), card);
        }
    }
}
