package steward.replay.page;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;

/** The page of a guest in a real browser: lines as they were said, the referee's own limits, and no empty field. */
class GuestPageTest extends PageTestCase {

    private static final List<String> LINES = List.of("""
        {"type":"steward-replay","format":3,"game":"guest","seed":"7","timeFactor":2,"players":[{"name":"left"},\
        {"name":"right"}],"scene":{"name":"heap","game":"guest","players":2},\
        "drawing":{"field":{"x":0,"y":0,"width":1600,"height":900},"walls":[],"zones":[],"bodies":[]},\
        "start":{"state":{"bodies":[],"asked":1,"said":[{"block":"NEXT_PLAYER_INFO","lines":["0","0","70"]},\
        {"block":"NEXT_PLAYER_INPUT","lines":["20"]},\
        {"block":"NEXT_PLAYER_INFO","lines":["1 2","1000"]}]}}}""", """
        {"type":"turn","turn":1,"commands":[null,{"lines":["TAKE 3","AND <wait>"]}],\
        "times":{"answerNanos":[null,5000000]},"outcome":{"state":{"bodies":[],"asked":0,"said":[\
        {"block":"VIEW","lines":["KEY_FRAME 1","{\\"heap\\": 17}"]},{"block":"INFOS","lines":[]},\
        {"block":"TOOLTIP","lines":["three","1"]},{"block":"NEXT_PLAYER_INPUT","lines":["17","x"]},\
        {"block":"NEXT_PLAYER_INFO","lines":["0","1","50"]}]}}}""", """
        {"type":"turn","turn":2,"commands":[{"lines":["TAKE 1"]},null],"times":{"answerNanos":[1000000,null]},\
        "outcome":{"state":{"bodies":[],"said":[{"block":"SCORES","lines":["0 0","1 1"]}]}}}""");

    @Test
    void aGuestIsShownByItsLines() {
        browser.open(pages.live("A heap"), "");
        LINES.forEach(line -> browser.run("steward.addTurn(arguments[0])", line));
        browser.run("steward.seek(1)");
        assertTrue(browser.is("document.body.classList.contains('drawingless')"), "there is nothing to draw");
        String cards = text("#cards");
        assertTrue(cards.contains("5.00 ms of 2000") && cards.contains("TAKE 3\nAND <wait>"), cards);
        assertEquals("askedleftVIEWKEY_FRAME 1\n{\"heap\": 17}TOOLTIPthree\n1NEXT_PLAYER_INPUT17\nx"
            + "NEXT_PLAYER_INFO0\n1\n50", text("#state"));
        browser.run("steward.seek(2)");
        assertTrue(text("#cards").contains("1.00 ms of 100"), text("#cards"));
        assertTrue(!text("#charts").contains("no deadlines"), text("#charts"));
    }

    private static String text(String selector) {
        return (String) browser.run("return document.querySelector(arguments[0]).textContent", selector);
    }
}
