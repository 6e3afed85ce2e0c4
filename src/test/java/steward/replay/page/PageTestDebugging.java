package steward.replay.page;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.openqa.selenium.Keys;
import steward.match.TestScenes;

/**
 * The page as a tool to find out what happened: happenings, moments, bodies, camera, keys. It takes long because each
 * test opens the page anew.
 */
class PageTestDebugging extends PageTestCase {

    private static Path page;

    @BeforeAll
    static void start() {
        page = pages.page(PageTestRaces.play(PageTestRaces.scene("mad-pod-racing"), 3), "Race");
    }

    @BeforeEach
    void atTurnThirty() {
        browser.prefer(true, false);
        browser.open(page, "#t=30.5");
    }

    @Test
    void aClickOnAHappeningGoesToItsMoment() {
        String when = browser.text("#happened li:first-child .when");
        browser.click("#happened li:first-child button");
        assertEquals(Double.parseDouble(when), browser.number("steward.time()"), 0.005);
        browser.await("the list does not follow",
            () -> when.equals(browser.text("#happened [aria-current] .when")));
    }

    @Test
    void theStateSaysOfWhichInstantItIsAndFollowsIt() {
        assertTrue(browser.text("#state-when").startsWith("places at 30.50"), browser.text("#state-when"));
        String within = browser.text("#state");
        browser.seek(31, 1);
        assertEquals("at the end of turn 31", browser.text("#state-when"));
        assertNotEquals(within, browser.text("#state"));
    }

    @Test
    void whereNoAnswerTimesWereMeasuredThereAreNone() {
        assertFalse(browser.text("#cards .answer-time").isEmpty());
        assertTrue(browser.text("#charts").toLowerCase().contains("answer time"));
        String timed = new String(PageTestRaces.play(PageTestRaces.scene("duel"), 3), StandardCharsets.UTF_8);
        byte[] untimed = timed.replaceAll("\"answerNanos\":\\[[^]]*]", "\"answerNanos\":[0,0]")
            .getBytes(StandardCharsets.UTF_8);
        browser.open(pages.page(untimed, "Untimed"), "#t=5");
        assertTrue(browser.is("document.querySelector('#cards .answer-time').hidden"));
        assertFalse(browser.text("#charts").toLowerCase().contains("answer time"));
    }

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

    @Test
    void aTapOnABodySelectsItAndTheCameraFollowsIt() {
        browser.click("#bodies .body-row:first-child");
        assertEquals(0, browser.number("steward.selected()"));
        double whole = browser.number("steward.camera().scale");
        browser.press("f");
        browser.press("f");
        assertEquals("selected", browser.run("return steward.camera().follow"));
        browser.await("the camera does not come nearer", () -> browser.number("steward.camera().scale") > 1.5 * whole);
        browser.press("0");
        browser.await("the camera does not go back",
            () -> Math.abs(browser.number("steward.camera().scale") / whole - 1) < 0.01);
    }

    /** The line of the first pod took effect, and the second was none: that pod's command is null in the replay. */
    @Test
    void aBotThatFailedInItsSecondLineShowsItsFirst() {
        String race = new String(PageTestRaces.play(PageTestRaces.scene("mad-pod-racing"), 3), StandardCharsets.UTF_8);
        byte[] failed = race.replaceFirst("(\"turn\":30,\"commands\":\\[\\[\\{[^}]*},)\\{[^}]*}", "$1null")
            .getBytes(StandardCharsets.UTF_8);
        browser.open(pages.page(failed, "Failed"), "#t=30");
        assertTrue(browser.text("#cards").contains("pod 1: nothing"), browser.text("#cards"));
    }

    @Test
    void wallsAreNamedByTheirSide() {
        browser.open(pages.page(PageTestRaces.play(PageTestRaces.scene("walled-race"), 3), "Walls"),
            "#t=20");
        assertTrue(browser.is("steward.impactWords().some(words => words.endsWith(' × bottom wall'))"));
        assertFalse(browser.is("steward.impactWords().some(words => words.endsWith(' × wall'))"));
    }

    @Test
    void scrubbingGoesOnPlayingIfItWas() {
        browser.run("steward.play()");
        assertEquals("true 12", browser.run("""
            const scrub = document.getElementById('scrub');
            scrub.dispatchEvent(new PointerEvent('pointerdown'));
            scrub.value = '12';
            scrub.dispatchEvent(new Event('input'));
            scrub.dispatchEvent(new PointerEvent('pointerup'));
            return steward.playing() + ' ' + steward.time();
            """));
    }

    @Test
    void menusCloseByEscapeAndByAClickOutside() {
        browser.click(".menu summary");
        assertTrue(browser.is("document.querySelector('.menu').open"));
        browser.press(Keys.ESCAPE);
        assertFalse(browser.is("document.querySelector('.menu').open"));
        browser.click(".menu summary");
        browser.click("#time");
        assertFalse(browser.is("document.querySelector('.menu').open"));
    }

    /** Only space and Enter belong to what was clicked: "was sent", "Show" and what is in it, a select, a button. */
    @Test
    void keysGoOnAfterAClickOnAControl() {
        browser.open(pageWithSent(), "#t=30.5");
        for (String control : List.of(".sent-box summary", ".menu summary", "[data-show=trails]", "#theme")) {
            browser.click(control);
            double before = browser.number("steward.time()");
            browser.press("]");
            assertTrue(browser.number("steward.time()") > before, control + ": ] goes to no impact");
            browser.press("v");
            assertFalse(browser.is("document.querySelector('[data-show=vectors]').checked"), control);
            browser.press("v");
            browser.press(Keys.ARROW_LEFT);
            assertFalse(browser.is("steward.playing()"), control);
        }
        browser.click(".sent-box summary");
        boolean wasOpen = browser.is("document.querySelector('.sent-box').open");
        browser.press(" ");
        assertEquals(!wasOpen, browser.is("document.querySelector('.sent-box').open"), "space is the summary's");
        assertFalse(browser.is("steward.playing()"));
    }

    private static Path pageWithSent() {
        byte[] race = PageTestRaces.play(PageTestRaces.scene("mad-pod-racing"), 3);
        return pages.page(race, "Race", PageExtras.of(TestScenes.TYPES));
    }

    @Test
    @Tag("campaign")
    void speedAndThemeAreRememberedAndArrowsNeverChangeASelect() {
        browser.run("document.getElementById('speed').focus()");
        browser.press(Keys.ARROW_RIGHT);
        assertEquals(31, browser.number("steward.time()"));
        assertEquals(1, browser.number("steward.speed()"));
        browser.press(Keys.ARROW_UP);
        browser.click("#theme");
        browser.open(page, "#t=1");
        assertEquals(2, browser.number("steward.speed()"));
        assertEquals("light", browser.run("return document.documentElement.dataset.theme"));
    }
}
