package steward.replay.page;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.openqa.selenium.Keys;
import tools.jackson.databind.JsonNode;

/**
 * The page in a real browser: what it draws, against the numbers of the replay. One long file: all of its tests look at
 * the page of one race. It takes long because each test opens the page anew.
 */
class PageTest extends PageTestCase {

    /** Places are computed in doubles from whole pixels; a hundredth of a pixel is far below what can be seen. */
    private static final double PIXELS = 0.01;
    /** Share of a pod's disc that must have its team's colour: hull and rim, less label, flash and neighbours. */
    private static final double COLOURED = 0.1;

    private static byte[] replay;
    private static List<JsonNode> lines;
    private static Path page;

    @BeforeAll
    static void start() {
        replay = PageTestRaces.play(PageTestRaces.scene("walled-race"), 3);
        lines = PageTestRaces.lines(replay);
        page = pages.page(replay, "Walled race");
    }

    @BeforeEach
    void allowMotion() {
        browser.prefer(true, false);
    }

    private static int lastTurn() {
        return lines.size() - 2;
    }

    /** The state after a turn, as the replay has it. */
    private static JsonNode state(int turn) {
        return turn == 0 ? lines.get(0).get("start").get("state") : lines.get(turn).get("outcome").get("state");
    }

    @Test
    void opensFromDiskWithoutComplaintOrRequest() {
        browser.open(page, "");
        browser.run("steward.pause(); steward.seek(steward.lastTurn())");
        assertEquals(List.of(), browser.requests());
        assertEquals(lastTurn(), browser.number("steward.lastTurn()"));
        assertEquals("Walled race", browser.text("h1"));
    }

    @Test
    void drawsPodsWhereTheReplaySaysTheyAre() {
        browser.open(page, "#turn=1");
        hideDecoration();
        for (int turn : new int[] {0, 1, 57, lastTurn()}) {
            browser.seek(turn, 1);
            assertEquals(turn, browser.number("steward.turn()"));
            List<Map<String, Object>> bodies = assertBodiesAt(state(turn).get("bodies"));
            for (Map<String, Object> body : bodies) {
                assertTrue(teamShare(body, number(body, "x"), number(body, "y")) > COLOURED,
                    () -> "turn " + turn + ": no pod is seen at " + body);
            }
        }
    }

    @Test
    void leavesTheFieldEmptyWhereNoPodIs() {
        browser.open(page, "#turn=57");
        hideDecoration();
        List<Map<String, Object>> then = bodies();
        browser.seek(lastTurn(), 1);
        List<Map<String, Object>> now = bodies();
        int compared = 0;
        for (Map<String, Object> old : then) {
            boolean isFree = now.stream().allMatch(body -> Math.hypot(number(body, "x") - number(old, "x"),
                number(body, "y") - number(old, "y")) > 4 * number(old, "radius"));
            if (isFree) {
                compared++;
                assertEquals(0, teamShare(old, number(old, "x"), number(old, "y")), 0.02);
            }
        }
        assertTrue(compared > 0, "no place was left by all pods");
    }

    /** Without impacts a body flies straight: half-way through the turn it is half-way. */
    @Test
    void movesStraightBetweenTurnsWithoutImpacts() {
        browser.open(page, "#turn=1");
        int turn = 1;
        while (lines.get(turn).get("outcome").has("paths")) {
            turn++;
        }
        browser.seek(turn, 0.5);
        assertEquals(turn - 0.5, browser.number("steward.time()"));
        for (Map<String, Object> body : bodies()) {
            int id = (int) number(body, "id");
            JsonNode before = state(turn - 1).get("bodies").get(id);
            JsonNode after = state(turn).get("bodies").get(id);
            assertAt(body, (before.get("x").asDouble() + after.get("x").asDouble()) / 2,
                (before.get("y").asDouble() + after.get("y").asDouble()) / 2);
        }
    }

    /** At the time of an impact both pods are where the referee saw them touch, and it flashes between them. */
    @Test
    void showsAnImpactBetweenTurnsAtItsTimeAndPlace() {
        browser.open(page, "#turn=1");
        hideDecoration();
        int turn = firstTurnWithOneImpactOfTwoPods();
        JsonNode impact = lines.get(turn).get("outcome").get("impacts").get(0);
        double time = impact.get("time").asDouble();
        browser.seek(turn, time - 0.02);
        double before = brightness(turn, time);
        browser.seek(turn, time);
        assertTrue(brightness(turn, time) > before + 20, "no flash");
        for (Map<String, Object> body : bodies()) {
            int id = (int) number(body, "id");
            if (id == impact.get("a").asInt()) {
                assertAt(body, impact.get("ax").asDouble(), impact.get("ay").asDouble());
            } else if (id == impact.get("b").asInt()) {
                assertAt(body, impact.get("bx").asDouble(), impact.get("by").asDouble());
            }
        }
    }

    @Test
    @Tag("campaign")
    void drawsMomentsOfImpactsWithTheBodiesThatMoveAndNoOthers() {
        assertNoOtherBodiesAtImpacts(5);
    }

    @Test
    @Tag("campaign")
    void drawsTheMomentOfEveryImpactWithTheBodiesThatMoveAndNoOthers() {
        assertNoOtherBodiesAtImpacts(1);
    }

    /** Bumpers have corners of their own when they are hit, but are no moving bodies. */
    private static void assertNoOtherBodiesAtImpacts(int each) {
        browser.open(page, "#turn=1");
        assertEquals(4, browser.number("""
            steward.impacts().filter((_, k) => k % EACH === 0).reduce((most, { time }) => {
              const turn = Math.ceil(time);
              steward.seek(turn, time - turn + 1);
              const exactly = steward.bodies().length;
              steward.seek(turn, time - turn + 1 + 1e-9);
              return Math.max(most, exactly, steward.bodies().length);
            }, 0)""".replace("EACH", Integer.toString(each))));
    }

    @Test
    void stepsFromImpactToImpact() {
        browser.open(page, "#turn=0");
        double first = impactTime(0);
        browser.click("[data-key=']']");
        assertEquals(first, browser.number("steward.time()"), 1e-12);
        browser.press("]");
        double second = browser.number("steward.time()");
        assertTrue(second > first);
        browser.press("[");
        assertEquals(first, browser.number("steward.time()"), 1e-12);
        browser.press("[");
        assertEquals(first, browser.number("steward.time()"), 1e-12, "there is none before the first");
    }

    @Test
    void playsAndPauses() {
        int from = lastTurn() - 40;
        browser.open(page, "#turn=" + from);
        assertFalse(browser.is("steward.playing()"), "a link to a turn stays there");
        browser.click("#play");
        assertTrue(browser.is("steward.playing()"));
        browser.await("time stands still", () -> browser.number("steward.time()") > from + 1);
        browser.press(" ");
        assertFalse(browser.is("steward.playing()"));
        double stopped = browser.number("steward.time()");
        browser.run("return new Promise(done => setTimeout(done, 100))");
        assertEquals(stopped, browser.number("steward.time()"));
        browser.press(Keys.ARROW_DOWN);
        assertEquals(0.5, browser.number("steward.speed()"));
        browser.run("const s = document.getElementById('speed'); s.value = '20'; s.dispatchEvent(new Event('change'))");
        assertEquals(20, browser.number("steward.speed()"));
        browser.press(" ");
        browser.await("it does not come to its end", () -> browser.number("steward.time()") == lastTurn());
        browser.await("it does not stop at its end", () -> !browser.is("steward.playing()"));
    }

    @Test
    void stepsByTurn() {
        browser.open(page, "#turn=10");
        browser.press(Keys.ARROW_RIGHT);
        assertEquals(11, browser.number("steward.time()"));
        browser.seek(12, 0.3);
        browser.press(Keys.ARROW_RIGHT);
        assertEquals(12, browser.number("steward.time()"));
        browser.seek(12, 0.3);
        browser.press(Keys.ARROW_LEFT);
        assertEquals(11, browser.number("steward.time()"));
        browser.press(Keys.END);
        assertEquals(lastTurn(), browser.number("steward.time()"));
        browser.press(Keys.ARROW_RIGHT);
        assertEquals(lastTurn(), browser.number("steward.time()"));
        browser.press(Keys.HOME);
        assertEquals(0, browser.number("steward.time()"));
    }

    @Test
    void scrubs() {
        browser.open(page, "#turn=1");
        browser.run("const r = document.getElementById('scrub'); r.value = '33.25';"
            + " r.dispatchEvent(new Event('input'))");
        assertEquals(33.25, browser.number("steward.time()"));
        browser.click("#scrub");                             // its middle
        assertEquals(lastTurn() / 2.0, browser.number("steward.time()"), 1);
    }

    @Test
    void readsAndWritesTheLinkToAMoment() {
        browser.open(page, "#turn=57");
        assertEquals(57, browser.number("steward.time()"));
        browser.press(Keys.ARROW_RIGHT);
        browser.await("the link stays", () -> browser.is("location.hash === '#t=58.00'"));
        browser.run("location.hash = '#turn=5'");
        browser.await("the link is not followed", () -> browser.number("steward.time()") == 5);
        browser.run("location.hash = '#t=28.66'");
        browser.await("a moment is not followed", () -> browser.number("steward.time()") == 28.66);
        browser.open(page, "#turn=999999");
        assertEquals(lastTurn(), browser.number("steward.time()"));
        browser.open(page, "#turn=abc");
    }

    @Test
    void writesWhatEachBotSaidAndDidInTheTurnShown() {
        browser.open(page, "#turn=57");
        JsonNode turn = lines.get(57);
        JsonNode command = turn.get("commands").get(1).get(0);
        browser.await("turn 57 is not shown", () -> browser.text("#turn-shown").equals("Turn 57"));
        String card = browser.text("#cards .card:nth-child(2)");
        assertTrue(card.contains("(" + command.get("x").asInt() + ", " + command.get("y").asInt() + ")"), card);
        assertTrue(card.contains(turn.get("messages").get(1).asString()), card);
        assertTrue(card.contains(turn.get("stderr").get(1).asString().lines().findFirst().orElseThrow()), card);
        assertFalse(card.contains("@line"), card);
        assertTrue(card.contains("ms of 75"), card);
        assertTrue(browser.text("#state").contains(turn.get("outcome").get("hash").asString()));
    }

    @Test
    void tellsTheResultAtTheEndOnly() {
        browser.open(page, "#turn=57");
        assertTrue(browser.is("document.getElementById('ending').hidden"));
        browser.seek(lastTurn(), 1);
        String ending = browser.text("#ending");
        JsonNode result = lines.get(lines.size() - 1);
        assertTrue(ending.contains(result.get("ending").asString()), ending);
        assertTrue(ending.contains("swift wins") || ending.contains("steady wins"), ending);
        browser.click("#ending .close");
        assertTrue(browser.is("document.getElementById('ending').hidden"));
    }

    @Test
    @Tag("campaign")
    void staysWithinTheWindowOnADeskAndOnAPhone() {
        for (int[] size : new int[][] {{1280, 720}, {390, 844}, {844, 390}, {1920, 1080}}) {
            browser.size(size[0], size[1]);
            browser.open(page, "#turn=57");
            String at = size[0] + "x" + size[1];
            assertTrue(browser.is("document.documentElement.scrollWidth <= " + size[0]), at);
            assertBodiesAt(state(57).get("bodies"));
            Map<String, Object> field = map(browser.run("return steward.field()"));
            assertTrue(number(field, "left") >= 0 && number(field, "right") <= size[0], () -> at + " " + field);
            assertTrue(number(field, "top") >= 0 && number(field, "bottom") <= size[1], () -> at + " " + field);
            assertTrue(browser.is("document.getElementById('play').getBoundingClientRect().bottom <= " + size[1]), at);
        }
    }

    @Test
    void aTapOnTheFieldPlaysAndPauses() {
        browser.size(390, 844);
        browser.open(page, "#turn=57");
        Map<String, Object> field = map(browser.run("return steward.field()"));
        double x = (number(field, "left") + number(field, "right")) / 2;
        double y = (number(field, "top") + number(field, "bottom")) / 2;
        browser.tap(x, y);
        browser.await("a tap does not play", () -> browser.is("steward.playing()"));
        browser.tap(x, y);
        browser.await("a tap does not pause", () -> !browser.is("steward.playing()"));
    }

    @Test
    void followsTheMachinesLightOrDarkAndHasASwitch() {
        String background = "return getComputedStyle(document.body).backgroundColor";
        browser.open(page, "#turn=57");
        Object dark = browser.run(background);
        browser.prefer(false, false);
        Object light = browser.run(background);
        assertNotEquals(dark, light);
        browser.click("#theme");
        assertEquals(dark, browser.run(background));
        hideDecoration();
        for (Map<String, Object> body : bodies()) {
            assertTrue(teamShare(body, number(body, "x"), number(body, "y")) > COLOURED, body::toString);
        }
    }

    @Test
    @Tag("campaign")
    void doesNotStartByItselfWhereMotionIsToBeReduced() {
        browser.open(page, "");
        assertTrue(browser.is("steward.playing()"));
        browser.prefer(true, true);
        browser.open(page, "");
        assertFalse(browser.is("steward.playing()"));
    }

    // ---- helpers -----------------------------------------------------------------------------------

    /** Switches off what is drawn over pods, but for impacts. */
    private static void hideDecoration() {
        browser.run("document.querySelectorAll('[data-show]:checked:not([data-show=impacts])')"
            + ".forEach(box => box.click())");
    }

    @SuppressWarnings("unchecked")
    private static Map<String, Object> map(Object value) {
        return (Map<String, Object>) value;
    }

    @SuppressWarnings("unchecked")
    private static List<Map<String, Object>> bodies() {
        return (List<Map<String, Object>>) browser.run("return steward.bodies()");
    }

    private static double number(Map<String, Object> object, String name) {
        return ((Number) object.get(name)).doubleValue();
    }

    private static List<Map<String, Object>> assertBodiesAt(JsonNode expected) {
        List<Map<String, Object>> bodies = bodies();
        assertEquals(expected.size(), bodies.size());
        for (Map<String, Object> body : bodies) {
            JsonNode state = expected.get((int) number(body, "id"));
            assertAt(body, state.get("x").asDouble(), state.get("y").asDouble());
        }
        return bodies;
    }

    /** A body's place on the screen, against its place in the replay and the field's corners on the screen. */
    private static void assertAt(Map<String, Object> body, double x, double y) {
        Map<String, Object> shown = map(browser.run("return steward.field()"));
        JsonNode field = lines.get(0).get("drawing").get("field");
        double scale = (number(shown, "right") - number(shown, "left")) / field.get("width").asDouble();
        assertEquals(number(shown, "left") + scale * (x - field.get("x").asDouble()), number(body, "x"), PIXELS);
        assertEquals(number(shown, "top") + scale * (y - field.get("y").asDouble()), number(body, "y"), PIXELS);
        assertEquals(scale * 400, number(body, "radius"), PIXELS);
    }

    /** The share of a disc's pixels that have its owner's colour, as read back from the canvas. */
    private static double teamShare(Map<String, Object> body, double x, double y) {
        return ((Number) browser.run("""
            const [x, y, radius, owner] = arguments;
            const canvas = document.getElementById('field');
            const { left, top, width } = canvas.getBoundingClientRect();
            const ratio = canvas.width / width;
            const size = Math.round(2 * radius * ratio);
            const pixels = canvas.getContext('2d').getImageData(Math.round((x - left - radius) * ratio),
                Math.round((y - top - radius) * ratio), size, size).data;
            const wanted = steward.colourOf(owner).match(/[0-9a-f]{2}/g).map(hex => parseInt(hex, 16));
            let alike = 0;
            for (let k = 0; k < pixels.length; k += 4) {
              const far = Math.hypot(...wanted.map((value, c) => value - pixels[k + c]));
              if (far < 40) alike++;
            }
            return alike / (pixels.length / 4);
            """, x, y, body.get("radius"), body.get("owner"))).doubleValue();
    }

    /** Mean brightness, 0..255, of a few pixels around the place of an impact. */
    private static double brightness(int turn, double time) {
        return ((Number) browser.run("""
            const [time] = arguments;
            const place = steward.impacts().find(impact => Math.abs(impact.time - time) < 1e-9);
            const canvas = document.getElementById('field');
            const { left, top } = canvas.getBoundingClientRect();
            const pixels = canvas.getContext('2d').getImageData(place.x - left - 2, place.y - top - 2, 5, 5).data;
            return pixels.reduce((sum, value) => sum + value, 0) / pixels.length;
            """, turn - 1 + time)).doubleValue();
    }

    private static int firstTurnWithOneImpactOfTwoPods() {
        for (int turn = 1; turn <= lastTurn(); turn++) {
            JsonNode impacts = lines.get(turn).get("outcome").get("impacts");
            if (impacts != null && impacts.size() == 1 && impacts.get(0).has("b") && impacts.get(0).get("b").asInt() < 4
                && !lines.get(turn - 1).path("outcome").has("impacts") && impacts.get(0).get("time").asDouble() > 0.1) {
                return turn;
            }
        }
        throw new AssertionError("the race has no such turn");
    }

    private static double impactTime(int index) {
        int seen = 0;
        for (int turn = 1; turn <= lastTurn(); turn++) {
            JsonNode impacts = lines.get(turn).get("outcome").get("impacts");
            for (int k = 0; impacts != null && k < impacts.size(); k++) {
                if (seen++ == index) {
                    return turn - 1 + impacts.get(k).get("time").asDouble();
                }
            }
        }
        throw new AssertionError("the race has no impact " + index);
    }
}
