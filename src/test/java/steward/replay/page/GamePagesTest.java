package steward.replay.page;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import steward.bot.Bot;
import steward.bots.BundledBots;
import steward.bots.fantasticbits.Captain;
import steward.bots.fantasticbits.Chaser;
import steward.bots.pokerchiprace.Glutton;
import steward.bots.pokerchiprace.Nibbler;
import steward.bots.searchrace.Driver;
import steward.match.TestScenes;
import steward.replay.Recorded;
import steward.text.TextFormat;

/** The looks of games in a real browser: every turn is drawn without a complaint, and what a player has is told. */
class GamePagesTest extends PageTestCase {

    /** Draws every turn, and goes back to the first. */
    private Recorded drawn(String scene, double from, double step, Bot... bots) {
        Recorded match = Recorded.of(TestScenes.open(scene), 7, List.of(bots));
        browser.open(pages.page(match.bytes(), scene), "");
        browser.draw(from, match.result().turns(), step);
        browser.run("steward.seek(0)");
        return match;
    }

    /** Checks what the first player's panel says, in large and in small letters, and what it says in the last turn. */
    private void assertTold(String large, String small, String atTheEnd) {
        assertTrue(browser.text("#scores .big").matches(large), browser.text("#scores .big"));
        assertTrue(browser.text("#scores .small").matches(small), browser.text("#scores .small"));
        browser.run("steward.seek(steward.lastTurn())");
        assertTrue(browser.text("#scores .big").matches(atTheEnd), browser.text("#scores .big"));
    }

    @Test
    void fantasticBitsTellsGoalsAndMagic() {
        Recorded match = drawn("fantastic-bits", 0.5, 1, BundledBots.of(new Captain()), BundledBots.of(new Chaser()));
        assertTrue(match.text().contains("\"spell\":\"flipendo\""), "spells are drawn too");
        assertTold("0 goals", "0 magic", (int) match.result().players().get(0).score() + " goals?");
    }

    @Test
    void thePokerChipRaceTellsAreasAndChips() {
        drawn("poker-chip-race", 0, 2.5, BundledBots.of(new Glutton()), BundledBots.of(new Nibbler()));
        assertTold("[0-9\u2009]+ u²", "[1-5] chips?( · .*)?", ".*");
    }

    @Test
    void theSearchRaceTellsTheTime() {
        Recorded race = drawn("search-race", 0, 20, BundledBots.of(new Driver()));
        assertTold("Lap 1/3", "0 of .*", TextFormat.fixed(race.result().players().get(0).score(), 2) + " turns");
    }
}
