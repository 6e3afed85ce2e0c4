package steward.replay.page;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;

/** The page of a match in a real browser in which one bot has limits of its own. */
class OwnLimitsPageTest extends PageTestCase {

    @Test
    void eachAnswerTimeStandsBesideTheLimitOfItsPlayer() {
        String replay = new String(PageTestRaces.play(PageTestRaces.scene("duel"), 5), StandardCharsets.UTF_8)
            .replaceFirst("\"protocol\":\"json\"}]", "\"protocol\":\"json\",\"time\":{\"firstAnswerMs\":500,"
                + "\"answerMs\":60}}]");
        Path page = pages.page(replay.getBytes(StandardCharsets.UTF_8), "Duel");
        browser.open(page, "#turn=1");
        assertLimits(1, 1000, 500);
        browser.run("steward.seek(2)");
        assertLimits(2, 75, 60);
    }

    private static void assertLimits(int turn, int... limits) {
        browser.await("turn " + turn + " is not shown", () -> browser.text("#turn-shown").equals("Turn " + turn));
        for (int player = 0; player < limits.length; player++) {
            String card = browser.text("#cards .card:nth-child(" + (player + 1) + ")");
            assertTrue(card.contains(" ms of " + limits[player]), card);
        }
    }
}
