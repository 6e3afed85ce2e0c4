package steward.replay.page;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.openqa.selenium.Keys;
import steward.game.GameTypes;
import steward.game.podrace.protocol.PodRaceType;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** The page of a match in which a bot failed, looked through to the end of the search: fault, stderr, frames, CSV. */
class PageTestFaults extends PageTestCase {

    private static final int FAILED = 30;
    /** A trace behind many lines, as of a bot in Python that prints what it thinks. */
    private static final String STDERR = "depth 1 score 3.5\\n".repeat(400) + "Traceback (most recent call last):\\n"
        + "  File \\\"bot.py\\\", line 10, in choose\\n    return table[\\\"target\\\"]\\nKeyError: 'target'\\n"
        + "goodbye\\n".repeat(40);

    private static Path page;
    private static List<JsonNode> lines;

    @BeforeAll
    static void start() {
        byte[] race = PageTestRaces.play(PageTestRaces.scene("mad-pod-racing"), 3);
        lines = PageTestRaces.lines(race);
        String failed = new String(race, StandardCharsets.UTF_8).replaceFirst(
            "(\"turn\":" + FAILED + ",\"commands\":.*?)(,\"outcome\":.*?\"stderr\":\\[)\"[^\"]*\"",
            "$1,\"faults\":[\"exited with status 1\",null]$2\"" + STDERR.replace("\\", "\\\\") + "\"");
        page = pages.page(failed.getBytes(StandardCharsets.UTF_8), "Failed",
            PageExtras.of(new GameTypes(List.of(new PodRaceType()))));
    }

    @BeforeEach
    void atTheFault() {
        browser.open(page, "#fault");
    }

    @Test
    void aLinkToTheFaultOpensThereWithTheErrorLineMarkedAndInView() {
        assertEquals(FAILED, browser.number("steward.time()"));
        assertEquals("KeyError: 'target'", browser.text("#cards mark"));
        assertTrue(browser.is("(() => { const mark = document.querySelector('#cards mark').getBoundingClientRect();"
            + " const box = document.querySelector('#cards mark').parentElement.getBoundingClientRect();"
            + " return mark.top >= box.top && mark.bottom <= box.bottom; })()"));
    }

    @Test
    void stepsGoToFaultsEventsAndImpactsByKey() {
        browser.run("steward.seek(1)");
        browser.press("x");
        assertEquals(FAILED, browser.number("steward.time()"));
        browser.press("x");
        assertTrue(browser.text("#told").contains("no later fault"), browser.text("#told"));
        browser.press(Keys.chord(Keys.SHIFT, "i"));
        double impact = browser.number("steward.time()");
        assertTrue(impact < FAILED && browser.is("steward.impacts().some(each => each.time === steward.time())"));
        browser.click("#cards .card:nth-child(2) .name");
        browser.click("#step-event [aria-label='Next event']");
        browser.await("no event of steady", () -> browser.text("#happened [aria-current]").contains("pod "));
        assertTrue(browser.text("#happened [aria-current] .who").matches("pod [23].*"),
            browser.text("#happened [aria-current]"));
    }

    @Test
    void aSearchFindsWhatBotsWroteAndWereSent() {
        browser.press("/");
        browser.press("keyerror");
        browser.await("nothing is found", () -> browser.text("#found-count").equals("1 place"));
        browser.run("steward.seek(1)");
        browser.press(Keys.ENTER);
        assertEquals(FAILED, browser.number("steward.time()"));
        browser.await("it is not marked", () -> browser.text("#cards mark").equals("KeyError"));
        browser.run("document.getElementById('search').value = '\"turnsLeft\":'; "
            + "document.getElementById('search').dispatchEvent(new Event('input'))");
        browser.await("no frames are found", () -> browser.text("#found").contains("sent"));
        browser.click("#found li:last-child button");
        assertTrue(browser.is("document.querySelector('#cards .sent-box').open"
            + " || document.querySelector('#cards .card:nth-child(2) .sent-box').open"));
        assertEquals("\"turnsLeft\": ", browser.run("return document.querySelector('#cards .sent mark').textContent"));
    }

    /** What was sent is the frame to the letter, but for line ends and spaces between its fields. */
    @Test
    void aSheetHasTheWholeFrameBrokenAtItsFields() {
        browser.click("#cards .sent-box summary");
        browser.click("#cards .sent-box [title^='Show']");
        String whole = browser.text(".sheet-content");
        assertTrue(whole.lines().count() > 20, whole);
        JsonNode frame = JsonMapper.shared().readTree(whole);
        assertEquals(FAILED, frame.get("turn").asInt());
        assertEquals(4, frame.get("pods").size());
        browser.press(Keys.ESCAPE);
        browser.click("[data-export='whole']");
        assertEquals(5, browser.number("document.querySelectorAll('.sheet-content tr').length"));
        assertTrue(browser.text(".sheet-content").contains("turnsLeft"), browser.text(".sheet-content"));
    }

    @Test
    void tablesHaveTheNumbersOfTheReplay() {
        String[] states = ((String) browser.run("return steward.csv().states")).split("\n");
        assertTrue(states[0].startsWith("turn,id,x,y,vx,vy,player,"), states[0]);
        int turns = lines.size() - 2;
        assertEquals(1 + 4 * (turns + 1), states.length);
        JsonNode body = lines.get(FAILED).get("outcome").get("state").get("bodies").get(2);
        assertTrue(states[1 + 4 * FAILED + 2].startsWith(FAILED + ",2," + body.get("x") + "," + body.get("y") + ","
            + body.get("vx") + "," + body.get("vy") + ","), states[1 + 4 * FAILED + 2]);
        String[] impacts = ((String) browser.run("return steward.csv().impacts")).split("\n");
        assertEquals("turn,time,a,b,wall,ax,ay,bx,by,impulse,energy", impacts[0]);
        assertEquals(lines.stream().mapToInt(line -> line.path("outcome").path("impacts").size()).sum(),
            impacts.length - 1);
        assertEquals(turns + 2, ((String) browser.run("return steward.csv(3).states")).split("\n").length);
        assertTrue(browser.is("document.getElementById('export-body').disabled"));
        browser.click("#bodies .body-row:first-child");
        browser.await("nothing is to be saved of the body", () -> browser.text("#export-body").equals("Body 0"));
    }

    @Test
    void thePanelIsMadeWiderAndFolded() {
        browser.run("document.getElementById('grip').focus()");
        browser.press(Keys.ARROW_LEFT);
        assertEquals(368, browser.number("document.querySelector('aside').offsetWidth"));
        assertEquals(FAILED, browser.number("steward.time()"), "the arrow is not one of the match");
        browser.press("d");
        assertFalse(browser.is("document.querySelector('aside').checkVisibility()"));
        assertEquals(1280, browser.number("document.getElementById('field').offsetWidth"));
        browser.press("d");
        browser.open(page, "");
        assertEquals(368, browser.number("document.querySelector('aside').offsetWidth"), "the width is kept");
    }

    /** Scores 0:0, 1:0, 1:2, 3:2, 4:2: from turn 3 on the first was ahead, and had been before. */
    @Test
    void theEndSaysSinceWhenTheWinnerWasAhead() {
        browser.open(pages.live("Ends"), "");
        addLine("{'type':'steward-replay','format':3,'game':'none','seed':'7','players':[{'name':'left'},"
            + "{'name':'right'}],'scene':{},'drawing':{},'start':{'state':{'scores':[0,0]}}}");
        String[] scores = {"[1,0]", "[1,2]", "[3,2]", "[4,2]"};
        for (int turn = 1; turn <= scores.length; turn++) {
            addLine("{'type':'turn','turn':" + turn + ",'commands':[{},{}],'outcome':{'scores':" + scores[turn - 1]
                + ",'state':{}}}");
        }
        addLine("{'type':'result','turns':4,'ending':'over','standing':[{'rank':0,'score':4},{'rank':1,'score':2}],"
            + "'players':[{},{}]}");
        browser.run("steward.seek(4)");
        assertTrue(browser.text("#ending .reason").contains("left was ahead from turn 3 to the end"),
            browser.text("#ending .reason"));
        browser.click("#ending .reason .then");
        assertEquals(3, browser.number("steward.time()"));
    }

    private static void addLine(String line) {
        browser.run("steward.addTurn(arguments[0])", line.replace('\'', '"'));
    }
}
