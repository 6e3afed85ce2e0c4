package steward.replay.page;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import steward.match.TestScenes;
import steward.replay.Recorded;

/** A sparse replay in a real browser: 4,001 bodies, so that each third state is kept, and the last. */
class SparsePageTest extends PageTestCase {

    private static final String SCENE = """
        { "name": "many", "game": "bodies", "players": 0, "field": { "width": 3000, "height": 3000 },
          "bodies": { "listed": [ { "x": 10, "y": 10, "vx": 1, "radius": 5 } ],
            "fill": { "shape": "lattice", "count": 4000, "radius": 10,
              "in": { "x": 50, "y": 50, "width": 2900, "height": 2900 } } },
          "play": { "maximumTurns": 4 }, "accuracy": { "advance": "event", "arithmetic": "double" } }
        """;

    @Test
    void ofATurnWithoutStateOnlyPlacesAreShown() {
        Recorded match = Recorded.of(TestScenes.TYPES.open(SCENE, "many.json"), 7, List.of());
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
