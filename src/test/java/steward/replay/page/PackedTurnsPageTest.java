package steward.replay.page;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import steward.match.TestScenes;
import steward.replay.Recorded;

/** Long replays in their pages: drawn from tables of numbers that are as precise as a screen shows. */
class PackedTurnsPageTest extends PageTestCase {

    /** Steps in the largest place, 1800; half of one is the largest rounding, and floats add a fraction of that. */
    private static final double STEP = 1800.0 / (1 << 16);

    /** 4,001 bodies, so that each third state is kept, and the last. */
    private static final String SPARSE = """
        { "name": "many", "game": "bodies", "players": 0, "field": { "width": 3000, "height": 3000 },
          "bodies": { "listed": [ { "x": 10, "y": 10, "vx": 1, "radius": 5 } ],
            "fill": { "shape": "lattice", "count": 4000, "radius": 10,
              "in": { "x": 50, "y": 50, "width": 2900, "height": 2900 } } },
          "play": { "maximumTurns": 4 }, "accuracy": { "advance": "event", "arithmetic": "double" } }
        """;

    /** The match drawn from its lines by one page and from its tables by another: same places, impacts and ways. */
    @Test
    void aPackedMatchIsDrawnAsThatOfItsLines() {
        byte[] replay = PackedTurnsTest.replay();
        assertTrue(replay.length > 2 << 20, () -> replay.length + " bytes are packed");
        Path page = pages.page(replay, "Gas", PageExtras.of(TestScenes.TYPES));
        browser.open(page, "#t=0");
        browser.run("window.plain = arguments[0].split('\\n').filter(line => line).map(line => JSON.parse(line))"
            + ".filter(line => line.type === 'turn')", new String(replay, StandardCharsets.UTF_8));
        assertEquals(300, browser.number("steward.lastTurn()"));
        assertEquals(0, browser.number("""
            plain.filter(({ turn, outcome }) => {
              const drawn = steward.match().turn(turn);
              const near = (one, other) => Math.abs(one - other) <= %s;
              return !(outcome.state.bodies.every(({ id, x, y, vx, vy }) => {
                const body = drawn.bodies.get(id);
                return near(body.x, x) && near(body.y, y) && near(body.vx, vx) && near(body.vy, vy);
              }) && (outcome.impacts ?? []).every((impact, k) => drawn.impacts[k].a === impact.a
                && drawn.impacts[k].b === impact.b && drawn.impacts[k].wall === impact.wall
                && near(drawn.impacts[k].time, impact.time) && near(drawn.impacts[k].ax, impact.ax))
                && drawn.impacts.length === (outcome.impacts ?? []).length
                && (outcome.paths ?? []).every(({ id, knots }) => knots.every(([t, x, y], k) => {
                  const knot = drawn.knots.get(id)[k];
                  return near(knot[0], t) && near(knot[1], x) && near(knot[2], y);
                })) && drawn.hash === outcome.hash);
            }).length""".formatted(0.51 * STEP)), "turns that are drawn otherwise");
        assertTrue(browser.text("#scene").endsWith("numbers rounded to the screen"),
            browser.text("#scene"));
    }

    /** The page of a replay that is too large says so, and draws straight lines between the turns that it has. */
    @Test
    void thePageSaysThatTurnsAreLeftOut() throws IOException {
        byte[] replay = PackedTurnsTest.replay();
        String text = PackedTurns.of(replay, PackedTurns.of(replay).length() / 2);
        Path page = pages.page(replay, "Gas");
        Path fewer = folder.resolve("fewer.html");
        Files.writeString(fewer, Files.readString(page).replace(PackedTurns.of(replay), text));
        browser.open(fewer, "#t=1");
        assertTrue(browser.text("#scene").matches(
            ".* · a state every \\d+ turns, numbers rounded to the screen · sparse.*"), browser.text("#scene"));
        assertEquals(100, browser.number("steward.bodies().length"));
        assertTrue(browser.text("#state-when").endsWith("the state of turn 1 was left out"));
        browser.run("steward.seek(300)");
        assertEquals("at the end of turn 300", browser.text("#state-when"));
    }

    @Test
    void ofATurnWithoutStateOnlyPlacesAreShown() {
        Recorded match = Recorded.of(TestScenes.TYPES.open(SPARSE, "many.json"), 7, List.of());
        Path page = pages.page(match.bytes(), "Many");
        browser.open(page, "");
        browser.run("steward.seek(2)");
        assertEquals("places at 2.00, straight from turn 0 to 3: the state of turn 2 was left out",
            browser.text("#state-when"));
        assertTrue(state().startsWith("idxy01210"), state().substring(0, 40));
        browser.run("steward.seek(3)");
        assertEquals("at the end of turn 3", browser.text("#state-when"));
        assertTrue(state().startsWith("idxyvxvy0131010"), state().substring(0, 40));
    }

    private static String state() {
        return (String) browser.run("return document.querySelector('#state').textContent");
    }
}
